// Browsers run no worker of a page that is opened from the disk: there it has no search.
if (location.protocol === "file:") {
  window.Worker = class { postMessage() {} };
  document.querySelector('[role="search"]')?.remove();
}
