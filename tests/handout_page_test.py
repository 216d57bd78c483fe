#!/usr/bin/env python3
"""Links, anchors, alt texts, tables, formulas and folds of handout.md and README.md, and of the page that is made of the handout.

    tests/handout_page_test.py            the Markdown
    tests/handout_page_test.py --page     the page; skipped where there is no pandoc
"""
import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
failures = []


def expect(holds, where, what):
    if not holds:
        failures.append(f"{where}: {what}")


def anchor(title):
    """As GitHub makes it."""
    title = re.sub(r"[`*]|\[([^]]*)\]\([^)]*\)", r"\1", title)
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def without_code(text):
    """Lines of code become empty, so that line numbers stay."""
    inside, lines = False, []
    for line in text.splitlines():
        fence = line.startswith("```")
        lines.append("" if inside or fence else line)
        inside ^= fence
    return lines, inside


def cells(line):
    """Of a row; code and escaped bars hold none."""
    bare = re.sub(r"`[^`]*`", "", line.replace("\\|", ""))
    return bare.strip().strip("|").count("|") + 1


def check_links(page, lines, anchors):
    for number, line in enumerate(lines, 1):
        where = f"{page}:{number}:1"
        for text, target in re.findall(r"!\[([^]]*)\]\(([^)]*)\)", line):
            expect(text.strip(), where, f"{target} has no words for who cannot see it; expected what it shows")
            expect((ROOT / target).is_file(), where, f"{target} is not there; expected a picture")
        for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
            file, _, name = target.partition("#")
            if not file:
                expect(name in anchors, where, f"no heading has the anchor #{name}; expected one of this page's")
            elif not file.startswith("http"):
                expect((ROOT / file).exists(), where, f"{file} is not there; expected a file of the project")


def check_tables(page, lines):
    width = 0
    for number, line in enumerate(lines, 1):
        if not line.startswith("|"):
            width = 0
            continue
        count = cells(line)
        width = width or count
        expect(count == width, f"{page}:{number}:1", f"a row of {count} cells; expected {width}, as its table's first row")


def check_formulas(where, line):
    """GitHub reads Markdown first, formulas then: a backslash before punctuation is gone by then, and _ may be emphasis."""
    for formula in re.findall(r"\$\$.*?\$\$|\$[^$]+\$", re.sub(r"`[^`]*`", "", line)):
        lost = re.findall(r"\\[^A-Za-z\s]", formula)
        expect(not lost, where, f"{' '.join(lost)} in a formula; expected words, or code outside of it")
        emphasis = re.search(r"[^\w\s]_\w.*\w_[^\w\s]", formula)
        expect(not emphasis, where, f"{formula}: emphasis from _ to _; expected letters before both, or braces behind")


def check_rest(page, text, lines):
    for number, line in enumerate(lines, 1):
        where = f"{page}:{number}:1"
        expect(line.count("$$") % 2 == 0, where, "a formula without end; expected $$ twice in the line")
        bare = re.sub(r"`[^`]*`|\$\$.*?\$\$", "", line)
        expect(bare.count("$") % 2 == 0, where, "a formula without end; expected $ twice in the line")
        expect(not re.search(r"[.;:] \* ", bare), where, "a list within a line; expected a line for each item")
        check_formulas(where, line)
    for tag in ("details", "summary"):
        expect(text.count(f"<{tag}>") == text.count(f"</{tag}>"), f"{page}:1:1", f"<{tag}> without end; expected as many </{tag}>")


def check_markdown(page):
    text = (ROOT / page).read_text()
    lines, open_fence = without_code(text)
    expect(not open_fence, f"{page}:1:1", "code without end; expected ``` again")
    titles = [m[2] for m in (re.match(r"(#+) (.*)", line) for line in lines) if m]
    anchors = [anchor(title) for title in titles]
    for name in {a for a in anchors if anchors.count(a) > 1}:
        expect(False, f"{page}:1:1", f"two headings have the anchor #{name}; expected different ones")
    check_links(page, lines, set(anchors))
    check_tables(page, lines)
    check_rest(page, text, lines)


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.ids, self.links, self.images, self.rows, self.words = [], [], [], [], []
        self.count = {"math": 0, "details": 0, "table": 0}
        self.silent = 0  # within what is not read: style, formulas' sources

    def handle_starttag(self, tag, attributes):
        a = dict(attributes)
        if "id" in a:
            self.ids.append(a["id"])
        if tag == "a" and "href" in a:
            self.links.append(a["href"])
        if tag == "img":
            self.images.append((a.get("src", ""), a.get("alt", "")))
        if tag in ("script", "link", "iframe"):
            expect(False, "handout.html:%d:%d" % self.getpos(), f"<{tag}>; expected a page that needs none")
        self.count[tag] = self.count.get(tag, 0) + 1
        self.silent += tag in ("style", "annotation", "code", "pre")

    def handle_endtag(self, tag):
        self.silent -= tag in ("style", "annotation", "code", "pre")

    def handle_data(self, data):
        if not self.silent:
            self.words.append(data)


def check_page(folder):
    done = subprocess.run([ROOT / "scenes/make_page", "--html", folder], capture_output=True, text=True)
    expect(done.returncode == 0, "scenes/make_page:1:1", done.stderr)
    text = (pathlib.Path(folder) / "handout.html").read_text()
    page, source = Page(), (ROOT / "handout.md").read_text()
    page.feed(text)
    where = "handout.html:1:1"
    for link in page.links:
        if link.startswith("#"):
            expect(link[1:] in page.ids, where, f"nothing has the id of {link}; expected the heading")
    expect(len(page.ids) == len(set(page.ids)), where, "an id twice; expected each once")
    expect(len(page.images) == source.count("!["), where, f"{len(page.images)} pictures; expected {source.count('![')}")
    for src, alt in page.images:
        expect(src.startswith("data:image/"), where, f"a picture from {src[:60]}; expected it within the page")
        expect(alt.strip(), where, "a picture without words; expected what it shows")
    for tag, found in (("details", source.count("<details>")), ("table", source.count("\n|---"))):
        expect(page.count[tag] == found, where, f"{page.count[tag]} <{tag}>; expected {found}")
    formulas = re.findall(r"\$\$.*?\$\$", source)
    display = len(formulas) + sum(len(re.findall(r"\\qquad|\\quad(?= [=+])", formula)) for formula in formulas)
    shown = text.count('<math display="block"')
    expect(shown == display, where, f"{shown} formulas in lines of their own; expected {display}")
    expect("$" not in "".join(page.words), where, "a $ is left; expected MathML")
    expect(not re.search(r'</m(?:i|sub|row)><mi mathvariant="normal">d</mi>', text), where, "no space before a differential")
    expect(not re.search(r"<semantics><mrow><mo>[=+]", text), where, "no space about a sign at the head of a part of a formula")
    plain = re.findall(r"\b[a-z]_[a-z],", "".join(page.words))  # descriptions of keys have what code has
    expect(not plain, where, f"{plain[:3]} as in TeX; expected <sub>")
    expect("<th></th>" not in text, where, "a head of a column without words; expected <td>")
    expect("prefers-color-scheme: dark" in text, where, "no dark mode; expected page.css")
    expect("url(data:font/woff2" in text and "url(math" not in text, where, "no font of formulas; expected math.woff2 within the page")
    last = [rule for rule in re.findall(r"\bhtml\s*\{([^}]*)\}", text) if "background" in rule][-1:]
    expect(last and "var(--paper)" in last[0], where, "margins of another colour than the text's; expected html in page.css")
    words = set(re.findall(r'<mi mathvariant="italic">([^<]{2,})</mi>', text))
    expect(not words, where, f"words in letters that stand apart: {', '.join(sorted(words))}; expected \\text{{...}}")


if sys.argv[1:] == ["--page"]:
    if shutil.which("pandoc") is None:
        print("there is no pandoc here")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as scratch:
        check_page(scratch)
else:
    check_markdown("handout.md")
    check_markdown("README.md")
print("\n".join(failures))
sys.exit(bool(failures))
