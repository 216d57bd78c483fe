"""What holds for every page: it fits every width, light and dark, asks nothing of a network, and axe-core finds nothing."""

import base64

from axe_playwright_python.sync_playwright import Axe

from helpers import expect
from opened import opened

WIDTHS = (320, 768, 1280, 1920)

# What stands beyond the edge or beyond its card, or in a box that scrolls on a narrow page: nobody sees that digits are
# missing.
CUT = """[...document.querySelectorAll('td, th, header p, .score, figcaption, svg.bar, svg.reach, .plot, .points')].filter(e => {
    const box = e.getBoundingClientRect(), scroll = e.closest('.scroll, .wide');
    if (!box.width || e.closest('[role=region]')) return false;  // that one goes sideways, by keyboard too, with a cue
    const card = e.closest('.card'), edge = card && !scroll && card.getBoundingClientRect().right;
    return (edge && box.right > edge - 4) || box.right > innerWidth + 1 || (scroll && innerWidth <= 640 && scroll.scrollWidth > scroll.clientWidth + 1);
}).map(e => e.textContent.trim().slice(0, 60))"""


def share_of_white(page, element):
    """Of an element's pixels as they are seen."""
    shot = base64.b64encode(element.screenshot()).decode()
    return page.evaluate("""async shot => {
        const image = new Image();
        image.src = 'data:image/png;base64,' + shot;
        await image.decode();
        const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
        const context = canvas.getContext('2d');
        context.drawImage(image, 0, 0);
        const bytes = context.getImageData(0, 0, image.width, image.height).data;
        let white = 0;
        for (let i = 0; i < bytes.length; i += 4) white += Math.min(bytes[i], bytes[i + 1], bytes[i + 2]) > 245;
        return 4 * white / bytes.length;
    }""", shot)


def check_dark(page, name):
    """Maps of differences, their scales and plots are dark on a dark page."""
    page.evaluate("for (const image of document.images) image.loading = 'eager'")
    page.wait_for_function("[...document.images].every(image => image.complete)")
    for what in (".map img", ".scale", ".plot svg", ".plot img", ".plots svg"):
        for element in page.locator(what).all()[:3]:
            if element.is_visible():
                white = share_of_white(page, element)
                expect(white < 0.2, f"{name}: {white:.0%} of {what} is white")


def check_axe(page, name):
    page.evaluate("for (const d of document.querySelectorAll('details')) d.open = true")
    for violation in Axe().run(page).response["violations"]:
        node = violation["nodes"][0]
        expect(False, f"{name}: {violation['id']}, {len(violation['nodes'])} times: {node['html'][:120]} "
                      f"{node['failureSummary'].splitlines()[-1]}")


def check_widths(browser, page_file, keep):
    for scheme in ("light", "dark"):
        for width in WIDTHS:
            name = f"{page_file.stem} of {page_file.parent.name} at {width}, {scheme}"
            asked = []
            options = {"viewport": {"width": width, "height": 900}, "color_scheme": scheme}
            with opened(browser, page_file, lambda request: asked.append(request.url), **options) as page:
                wide = page.evaluate("document.documentElement.scrollWidth")
                expect(wide <= width, f"{name}: {wide} wide")
                outside = [url for url in asked if not url.startswith(("file:", "data:"))]
                expect(not outside, f"{name}: asks for {outside}")
                cut = page.evaluate(CUT)
                expect(not cut, f"{name}: cut off: {cut[:3]}")
                if (width, scheme) == (768, "dark"):
                    check_dark(page, name)
                if width in (320, 1280) and (page_file.stem == "handout" or (width == 320) == (scheme == "light")):
                    check_axe(page, name)
                if keep:
                    page.evaluate("for (const image of document.images) image.loading = 'eager'")
                    page.wait_for_function("[...document.images].every(image => image.complete)")
                    page.screenshot(path=keep / f"{page_file.parent.name}_{page_file.stem}_{scheme}_{width}.png", full_page=True)


def check_handout(browser, page_file):
    """Links differ from text before and after a visit, light and dark; tables have names that tell them apart."""
    for scheme in ("light", "dark"):
        with opened(browser, page_file, color_scheme=scheme) as page:
            rules = page.evaluate("[...document.styleSheets].flatMap(s => [...s.cssRules]).filter(r => r.selectorText === 'a:visited')"
                                  ".map(r => r.cssText)")
            expect(not rules, f"handout, {scheme}: pandoc's own style for visited links: {rules}")
            pairs = "[...document.querySelectorAll('.pictures tr:not(:has(td + td + td)) img')]"
            sizes = page.evaluate("[getComputedStyle(document.documentElement).fontSize, "
                                  f"Math.min(...{pairs}.map(i => i.getBoundingClientRect().width))]")
            expect(sizes[0] == "16px" and sizes[1] >= 480, f"handout, {scheme}: size of text and least width of pictures {sizes}")
    with opened(browser, page_file, viewport={"width": 320, "height": 800}) as page:
        lines = page.evaluate("[...document.querySelectorAll('.keys td:nth-last-child(4)')].map(td => td.getClientRects().length)")
        expect(len(lines) > 50 and max(lines) == 1, f"handout, 320 wide: lines of the {len(lines)} keys {lines}")
        drawn = page.evaluate("[...document.querySelectorAll('.drawing img')].map(i => i.getBoundingClientRect().width)")
        expect(len(drawn) > 10 and min(drawn) >= 440, f"handout, 320 wide: widths of drawings {drawn}")
    with opened(browser, page_file) as page:
        names = page.evaluate("[...document.querySelectorAll('[role=region]')].map(e => e.ariaLabel)")
        expect(len(names) > 50 and len(names) == len(set(names)), f"handout: {len(names) - len(set(names))} tables go by another one's name")
