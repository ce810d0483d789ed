"""Lines of a job's log: at the start, at each tenth, at the end."""

from pyworm.io.progress import log_lines, marks_tenth


def test_a_line_at_the_start_of_each_kind_of_work_and_at_each_tenth():
    said = []
    tell = log_lines(said.append, "share 1/3")
    for number in range(1, 6):
        tell(f"{number} of 5 cases checked", number / 5)
    for number in range(40):
        tell(f"scene {number}", number / 40)
        tell("again", (number + 0.5) / 40)
    tell("the last", 1.0)
    assert said[:5] == [
        "share 1/3: 20 %, 1 of 5 cases checked",
        *(f"share 1/3: {20 * n} %, {n} of 5 cases checked" for n in (2, 3, 4, 5)),
    ]
    assert said[5] == "share 1/3: 0 %, scene 0"
    tenths = [f"share 1/3: {10 * n} %, scene {4 * n}" for n in range(1, 10)]
    assert said[6:] == [*tenths, "share 1/3: 100 %, the last"]


def test_workers_mark_the_first_each_tenth_and_the_last():
    assert [n for n in range(1, 31) if marks_tenth(n, 30)] == [1, *range(3, 31, 3)]
    assert all(marks_tenth(n, 4) for n in range(1, 5))
