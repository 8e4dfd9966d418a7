"""browse.py CHROMIUM SITE [--within SECONDS] [--pictures FOLDER]: opens every page of a site and says what is wrong.

The browser is a headless Chromium without a network. Of each page: links lead to a file and a place in it, images show,
nothing is asked of a network, nothing is wider than a phone (390 px) or a desktop (1280 px), it prints, the headings of
its first table sort, a filter keeps the rows that it should, no script complains; with --within the index and all
beside it open so soon. With --pictures screenshots and prints are left in a folder. A browser that hangs is ended, with
all that it started: where it takes longer than --longest for an answer, or answers more than 64 MiB.
"""
import argparse
import base64
import contextlib
import json
import math
import os
import pathlib
import select
import signal
import subprocess
import sys
import tempfile
import time
import urllib.parse

WIDTHS = {"desktop": 1280, "phone": 390}  # px
MOST_PICTURED = 8000  # px, of a page's height
MOST_ANSWERED = 64 << 20  # bytes, of one answer


class Browser:
    """A headless Chromium that is spoken to over two pipes (DevTools protocol)."""

    def __init__(self, program, profile, longest):
        to_browser, self.out = os.pipe()
        self.incoming, from_browser = os.pipe()
        # The browser reads from 3 and writes to 4.
        words = f'exec "$@" 3<&{to_browser} 4>&{from_browser}'
        self.process = subprocess.Popen(
            ["bash", "-c", words, "bash", program, "--headless", "--no-sandbox", "--disable-gpu",
             "--remote-debugging-pipe", f"--user-data-dir={profile}", "--no-first-run", "--disable-dev-shm-usage",
             "--disable-background-networking"],
            pass_fds=(to_browser, from_browser), stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            start_new_session=True)
        os.close(to_browser)
        os.close(from_browser)
        self.longest, self.rest, self.events, self.number, self.session = longest, b"", [], 0, None

    def begin(self):
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Network", "Runtime"):
            self.ask(domain + ".enable")

    def expect(self):
        """From now on an answer may take so long and hold so much, whatever else is told until then."""
        self.until, self.may_come = time.monotonic() + self.longest, MOST_ANSWERED

    def message(self):
        pieces = [self.rest]
        while b"\0" not in pieces[-1]:
            pieces.append(self.piece())
        line, self.rest = b"".join(pieces).split(b"\0", 1)
        try:
            message = json.loads(line)
        except (ValueError, RecursionError):
            message = None
        if not isinstance(message, dict):
            sys.exit(f"browse.py: the browser says {line[:40]!r}, expected a message in JSON")
        return message

    def piece(self):
        left = self.until - time.monotonic()
        if left <= 0 or not select.select([self.incoming], [], [], left)[0]:
            sys.exit(f"browse.py: the browser did not answer within {self.longest:g} s")
        piece = os.read(self.incoming, 1 << 20)
        self.may_come -= len(piece)
        if self.may_come < 0:
            sys.exit(f"browse.py: the browser answered more than {MOST_ANSWERED >> 20} MiB")
        if not piece:
            sys.exit("browse.py: the browser ended before it answered")
        return piece

    def ask(self, method, **parameters):
        self.expect()
        self.number += 1
        question = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            question["sessionId"] = self.session
        text = json.dumps(question).encode() + b"\0"
        try:
            while text:
                text = text[os.write(self.out, text):]
        except BrokenPipeError:
            sys.exit("browse.py: the browser ended before it was asked")
        while True:
            message = self.message()
            if message.get("id") == self.number:
                if "error" in message:
                    sys.exit(f"browse.py: {method}: {message['error']['message']}")
                return message["result"]
            self.events.append(message)

    def run(self, script):
        """The value of a script, or its complaint."""
        answer = self.ask("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        return answer["result"].get("value", answer.get("exceptionDetails", {}).get("text"))

    def open(self, page, width):
        """Shows a page; the seconds that it took to load and be drawn."""
        self.events.clear()
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=width < 600)
        start = time.monotonic()
        self.ask("Page.navigate", url=page.as_uri())
        self.expect()
        while not any(event.get("method") == "Page.loadEventFired" for event in self.events):
            self.events.append(self.message())
        self.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        return time.monotonic() - start

    def close(self):
        self.session = None
        self.ask("Browser.close")
        with contextlib.suppress(subprocess.TimeoutExpired):
            self.process.wait(20)

    def kill(self):
        """Ends it, where it has not ended, and all that it started."""
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()


LINKS = "[...document.querySelectorAll('[href],[src]')].map(e => e.getAttribute('href') ?? e.getAttribute('src'))"
IDS = "[...document.querySelectorAll('[id]')].map(e => e.id)"
# Images that are loaded when they come into view are asked for at once.
UNSHOWN = r"""Promise.all([...document.images].map(image => {
  image.loading = 'eager';
  return image.decode().then(() => null, () => image.getAttribute('src'));
})).then(all => all.filter(src => src !== null))"""
WIDTH = "document.documentElement.scrollWidth"
HEIGHT = "document.documentElement.scrollHeight"
# Clicks each heading of the first table that may be sorted, twice, and compares the order with that of the cells' keys.
SORTS = r"""(() => {
  const table = document.querySelector('table:not(.matrix *, .flows *)');
  if (!table) return 'none';
  for (const heading of table.tHead.rows[0].cells)
    for (const expected of ['ascending', 'descending']) {
      heading.click();
      if (heading.getAttribute('aria-sort') !== expected) return `'${heading.textContent}' is not ${expected}`;
      const texts = [...table.tBodies[0].rows].map(r => r.cells[heading.cellIndex].textContent.trim());
      const numbers = texts.map(Number);
      if (numbers.some(Number.isNaN) || texts.includes('')) continue;
      const way = expected === 'ascending' ? 1 : -1;
      if (numbers.some((n, i) => i > 0 && way * (n - numbers[i - 1]) < 0))
        return `'${heading.textContent}' is not sorted`;
    }
  return 'sorted';
})()"""
# What the first filter leaves for a word that nobody writes, and for the last word of the first row.
FILTERS = r"""(() => {
  const field = document.querySelector('.filtered input');
  if (!field) return 'none';
  const rows = [...document.querySelectorAll('.filtered tbody tr')];
  const left = word => {
    field.value = word;
    field.dispatchEvent(new Event('input'));
    return rows.filter(row => !row.hidden).length;
  };
  const none = left('qqqq'), some = left(rows[0].cells[0].textContent);
  return none === 0 && some > 0 && left('') === rows.length ? 'filtered' : `${none} and ${some} rows`;
})()"""
# A finger on the middle of the first curve.
SHOWS = r"""(() => {
  const trend = document.querySelector('.trend');
  if (!trend) return 'none';
  const svg = trend.querySelector('svg'), box = svg.getBoundingClientRect();
  const middle = {bubbles: true, clientX: box.left + box.width / 2, clientY: box.top};
  svg.dispatchEvent(new PointerEvent('pointermove', middle));
  return trend.lastElementChild.textContent;
})()"""


def broken_links(page, links, places):
    """What leads nowhere."""
    for link in links:
        parts = urllib.parse.urlsplit(link)
        if parts.scheme or parts.netloc:
            continue  # another site: what is loaded from one is found among the requests
        target = (page.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else page
        if not target.is_file():
            yield f"link to '{link}', which is not there"
        elif parts.fragment and target.suffix == ".html" and parts.fragment not in places[target]:
            yield f"link to '{link}', a place that is not there"


def complaints_in(events):
    for event in events:
        method, said = event.get("method"), event.get("params", {})
        if method == "Runtime.exceptionThrown":
            yield f"a script fails: {said['exceptionDetails'].get('exception', {}).get('description', '?')}"
        url = said.get("request", {}).get("url", "file:")
        if method == "Network.requestWillBeSent" and not url.startswith(("file:", "data:", "about:")):
            yield f"asks for {url}, expected no network"
        if method == "Network.loadingFailed" and not said.get("canceled"):
            yield f"could not load something: {said['errorText']}"


def check(browser, site, page, places, within, pictures):
    seconds = browser.open(page, WIDTHS["desktop"])
    yield from complaints_in(browser.events)
    yield from broken_links(page, browser.run(LINKS), places)
    for _ in range(2):  # a busy machine may be slow once
        if seconds > within:
            seconds = min(seconds, browser.open(page, WIDTHS["desktop"]))
    if page.parent == site and seconds > within:
        yield f"opened in {seconds:.2f} s, expected {within} s"
    yield from (f"image '{image}' does not show" for image in browser.run(UNSHOWN))
    for name, width in WIDTHS.items():
        browser.open(page, width)
        found = browser.run(WIDTH)
        if found > width:
            yield f"is {found} px wide on a {name} of {width} px"
        if pictures:
            height = min(MOST_PICTURED, browser.run(HEIGHT))
            shot = browser.ask("Page.captureScreenshot", captureBeyondViewport=True,
                               clip={"x": 0, "y": 0, "width": width, "height": height, "scale": 1})
            name = f"{page.parent.name}_{page.stem}_{name}.png"
            (pictures / name).write_bytes(base64.b64decode(shot["data"]))
    printed = base64.b64decode(browser.ask("Page.printToPDF", printBackground=True)["data"])
    if not printed.startswith(b"%PDF") or printed.count(b"/Type /Page\n") + printed.count(b"/Type /Page ") == 0:
        yield "does not print"
    if pictures:
        (pictures / f"{page.parent.name}_{page.stem}.pdf").write_bytes(printed)
    sorted_by = browser.run(SORTS)
    if sorted_by not in ("sorted", "none"):
        yield f"a table does not sort: {sorted_by}"
    filtered = browser.run(FILTERS)
    if filtered not in ("filtered", "none"):
        yield f"a table does not filter: {filtered}"
    shown = browser.run(SHOWS)
    if shown != "none" and ": " not in shown:
        yield f"a curve shows '{shown}', expected night, revision and value"
    print(f"{page.parent.name}/{page.name}: opened in {seconds:.2f} s, {page.stat().st_size / 1e6:.2f} MB, "
          f"{len(printed) / 1e6:.2f} MB in print")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program", metavar="CHROMIUM")
    arguments.add_argument("site", metavar="SITE", type=pathlib.Path)
    arguments.add_argument("--within", metavar="SECONDS", type=float, default=math.inf)
    arguments.add_argument("--pictures", metavar="FOLDER", type=pathlib.Path)
    arguments.add_argument("--longest", metavar="SECONDS", type=float, default=120)
    named = arguments.parse_args()
    site, pictures = named.site.resolve(), named.pictures
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
    pages = sorted(site.rglob("*.html"))
    if not pages:
        sys.exit(f"browse.py: {site}: no pages, expected a site")
    wrong = 0
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(named.program, profile, named.longest)
        try:
            browser.begin()
            places = {}  # that links may lead to, by page
            for page in pages:
                browser.open(page, WIDTHS["desktop"])
                places[page] = browser.run(IDS)
            for page in pages:
                for what in check(browser, site, page, places, named.within, pictures):
                    wrong += 1
                    print(f"{page.relative_to(site)}: {what}", file=sys.stderr)
            browser.close()
        finally:
            browser.kill()
    print(f"{len(pages)} pages opened, {wrong} faults")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
