// Controls, and the drawing of all panels.

let playing = null;

function update() {
  const one = scene();
  element("slider").value = state.scene;
  element("place").textContent = one.name;
  drawMap();
  drawProfiles();
  drawFlank();
  drawSpace();
  element("figures-title").textContent = `Results, ${one.name}`;
  const rows = one.rows.map(([name, value]) => {
    const row = document.createElement("tr");
    for (const text of [name, value]) row.appendChild(document.createElement("td")).textContent = text;
    if (value === "NO") row.className = "alarm";
    return row;
  });
  element("figures").replaceChildren(...rows);
}

function options(id, quantities, chosen, change) {
  const select = element(id);
  for (const [name, of] of Object.entries(quantities)) select.add(new Option(label(of), name, false, name === chosen));
  select.addEventListener("change", () => { change(select.value); update(); });
}

function show(number) {
  state.scene = number;
  update();
}

function play() {
  clearInterval(playing);
  playing = playing ? null : setInterval(() => show((state.scene + 1) % page.scenes.length), 600);
  element("play").textContent = playing ? "❚❚" : "▶";
}

function begin() {
  const several = page.scenes.length > 1;
  element("slider").max = page.scenes.length - 1;
  element("slider").hidden = element("play").hidden = !several;
  element("slider").addEventListener("input", (event) => show(Number(event.target.value)));
  element("play").addEventListener("click", play);
  options("field", page.fields, state.field, (name) => { state.field = name; });
  element("range").addEventListener("change", (event) => { state.range = event.target.value; update(); });
  element("flank-part").hidden = !page.flank;
  if (page.flank) options("flank-field", page.maps, state.flankField, (name) => { state.flankField = name; });
  element("space-part").hidden = !page.space;
  element("map").hidden = element("map-read").hidden = !page.scenes[0].y;
  if (page.space) watchSpace();
  window.addEventListener("resize", update);
  update();
}

begin();
