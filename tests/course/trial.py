"""What course systems export beside the ordinary: a part of class_test.py."""

from classes import archive, folder, rows, text
from helpers import BLANKS, expect, record_at, run


def trial_class(at):
    """What the course systems export beside the ordinary: archives in folders, an attachment a file, copies, essays, links."""
    at.mkdir()
    (at / "Jane Doe_111_assignsubmission_file_").mkdir()
    archive(at / "Jane Doe_111_assignsubmission_file_/work.zip", {"starter/fragments/moved.cpp": text("moved")})
    folder(at / "Jane Doe_111_assignsubmission_onlinetext_", {"onlinetext.html": "<p>see the file</p>"})
    folder(at / "Ty Ped_112_assignsubmission_onlinetext_", {"onlinetext.html": "<p>my work</p>"})
    blank = (BLANKS / "moved.cpp").read_text()
    folder(at, {"kimpat_42345_67894_phong.cpp": text("phong"), "kimpat_42345_67895_hit_sphere.cpp": text("hit_sphere"),
                # of three copies that of the last upload, which is neither the first nor the last by name
                "kimpat_42345_100000_moved-2.cpp": text("moved"), "kimpat_42345_67896_moved.cpp": blank,
                "kimpat_42345_99999_moved-3.cpp": blank})
    folder(at, {"twoatt_43345_67897_mirror_direction-2.cpp": text("mirror_direction"), "twoatt_43345_67898_Moved.cpp": text("moved")})
    folder(at, {"nowork_52345_67896_essay.pdf": "%PDF", "submission_metadata.yml":
                '---\nsubmission_9:\n  :submitters:\n  - :name: "=HYPERLINK(\\"h\\\\\\u00e9\\x41\\")"\n    :sid: \'it\'\'s\'\n'})
    folder(at / "submission_9", {"moved.cpp": text("moved")})
    folder(at / "Em Pty_114_assignsubmission_file_", {path.name: path.read_text() for path in BLANKS.glob("*.cpp")})
    archive(at / "Near Ly_115_assignsubmission_file_work.zip", {"Phong.cpp": text("phong"), "hit-sphere.cpp": text("hit_sphere")})
    # a zip, and a file of it once more; a zip that came through half
    folder(at / "Both Ways_113_assignsubmission_file_", {"moved.cpp": blank})
    archive(at / "Both Ways_113_assignsubmission_file_/all.zip", {"moved.cpp": text("moved"), "mirror_direction.cpp": text("mirror_direction")})
    whole = archive(at / "half_72345_67900_work.zip", {"moved.cpp": text("moved"), "phong.cpp": text("phong")})
    (at / "half_72345_67900_work.zip").write_bytes(whole[:len(whole) // 2])
    (at / "hw1-link").symlink_to(at / "submission_9")


def check_trial(grade, work):
    export, out = work / "trial", work / "trial-out"
    trial_class(export)
    said = run([grade, "class", export, "-o", out, "--seed", "5", "--jobs", "2"], 1)
    table = {row["student"]: row for row in rows(out / "class.csv")}
    points = {name: row["points"] for name, row in table.items()}
    worth = {f["name"]: f["max_points"] for f in record_at(out / "submissions/submission_9.json")["fragments"]}
    total = lambda *names: f"{sum(worth[name] for name in names):g}"
    hyperlink = '\'=HYPERLINK("h\\éA")'
    expected = {"Jane Doe": total("moved"), "Ty Ped": "", "kimpat": total("phong", "hit_sphere", "moved"),
                "twoatt": total("mirror_direction"), "nowork": "", hyperlink: total("moved"), "Near Ly": "0", "hw1-link": "",
                "Both Ways": total("moved", "mirror_direction"), "half": "", "Em Pty": "0"}
    expect(points == expected, f"points are {points}, expected {expected}")
    expect(table[hyperlink]["id"] == "it's", f"an apostrophe in YAML: {table[hyperlink]['id']}")
    page = (out / "index.html").read_text()
    moodle = {row["Full name"]: row["Feedback comments"] for row in rows(out / "moodle.csv")}
    everything = total(*worth)
    expect(moodle["Em Pty"] == f"0 of {everything} points\nall fragments 0 of {everything}: not started",
           f"what is said of a hand-in without a line: {moodle['Em Pty']}")
    for who in ("Near Ly", "Jane Doe"):
        expect(moodle[who].count(": not in the submission") == 1, f"what is said of what is missing: {moodle[who]}")
    for who, what in [("kimpat", "kimpat_42345_100000_moved-2.cpp was taken, the latest; not kimpat_42345_99999_moved-3.cpp"),
                      ("kimpat", "not kimpat_42345_67896_moved.cpp"), ("twoatt", "there is Moved.cpp: rename it to moved.cpp"),
                      ("Near Ly", "phong: not in the submission; there is Phong.cpp: rename it to phong.cpp"),
                      ("Near Ly", "there is hit-sphere.cpp: rename it to hit_sphere.cpp"),
                      ("nowork", "essay.pdf: is neither source nor an archive"), ("Ty Ped", "typed into Moodle"),
                      ("Both Ways", "what is in all.zip/ was taken: it holds more fragments"),
                      ("half", "cannot be unpacked: it is cut off"), ("hw1-link", "hw1-link: is a link")]:
        for where, words in [("class.csv", table[who]["notes"]), ("the terminal", said), ("the page", page)]:
            expect(what in words, f"{who}: {where} does not say: {what}: {words if where != 'the page' else ''}")
        if not points[who] and who in moodle:
            expect(what in moodle[who], f"{who}: moodle.csv does not say: {what}")
    expect(set(moodle) == {"Jane Doe", "Ty Ped", "Em Pty", "Near Ly", "Both Ways"}, f"whom Moodle knows: {set(moodle)}")
    expect("nowork" in {row["Student"] for row in rows(out / "canvas.csv")}, "who has no points is not in Canvas's table")
    expect(table["Jane Doe"]["notes"] == "", f"a note where there is nothing to know: {table['Jane Doe']['notes']}")
    expect("11 submissions, 7 graded" in said, f"how many: {said}")

    # nobody can be graded
    none = work / "none-out"
    folder(work / "essay", {"nowork_52345_67896_essay.pdf": "%PDF"})
    said = run([grade, "class", work / "essay", "-o", none], 2)
    expect("1 submission, 0 graded" in said and "no submission could be read" in said, f"nobody: {said}")
    expect("essay.pdf" in rows(none / "class.csv")[0]["notes"] and "1 submission," in (none / "index.html").read_text(), "nobody")
    run([grade, export / "Jane Doe_111_assignsubmission_file_", "--seed", "5", "--json", work / "jane.json"])
    moved = next(f for f in record_at(work / "jane.json")["fragments"] if f["name"] == "moved")
    expect(moved["verdict"] == "passed", f"grade FOLDER does not look into the archive in it: {moved['verdict']}")
