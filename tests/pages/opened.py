"""A page in the browser."""

import contextlib

patience = 600_000  # ms: of a machine that does much else


@contextlib.contextmanager
def opened(browser, page_file, on_request=None, **options):
    page = browser.new_page(**options)
    page.set_default_timeout(patience)
    if on_request:
        page.on("request", on_request)
    page.goto(page_file.as_uri())
    yield page
    page.close()
