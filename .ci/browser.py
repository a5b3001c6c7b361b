#!/usr/bin/env python3
"""Looks at a report in a browser, as a reader would: python3 .ci/browser.py reports/index.html

Needs chromium and chromedriver, nothing else. One line for each check, then a count; exit code 1 if one failed.
"""

import contextlib
import json
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

FLAGS = [
    "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-dev-shm-usage",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
]

# Everything below runs in the page. A text is a box of a text node's line; boxes are shrunk a little, since fonts
# reserve more height than letters use.
LAYOUT = r"""
const found = {page: [], figures: [], outside: [], overlaps: [], texts: 0, plots: 0};
const root = document.documentElement;
if (root.scrollWidth > root.clientWidth) found.page.push(`page is ${root.scrollWidth} wide in ${root.clientWidth}`);
const say = (s) => s.trim().replace(/\s+/g, ' ').slice(0, 40);
const clash = (a, b) => Math.min(a.r, b.r) - Math.max(a.l, b.l) > 1 && Math.min(a.b, b.b) - Math.max(a.t, b.t) > 1;
const sweep = (boxes, where, list) => {
  boxes.sort((a, b) => a.t - b.t);
  let open = [];
  for (const box of boxes) {
    open = open.filter((o) => o.b > box.t);
    for (const o of open) if (clash(o, box)) list.push(`${where}: "${o.s}" and "${box.s}"`);
    open.push(box);
  }
};
for (const svg of document.querySelectorAll('svg.plot')) {
  const frame = svg.getBoundingClientRect();
  if (frame.width === 0) continue;
  found.plots += 1;
  const where = say(svg.querySelector('title').textContent);
  const boxes = [...svg.querySelectorAll('text')].map((text) => {
    const r = text.getBoundingClientRect(), shave = 0.2 * r.height;
    found.texts += 1;
    if (r.left < frame.left - 1 || r.right > frame.right + 1 || r.top + shave < frame.top - 1 || r.bottom - shave > frame.bottom + 1)
      found.figures.push(`${where}: "${say(text.textContent)}" leaves the plot`);
    return {l: r.left, r: r.right, t: r.top + shave, b: r.bottom - shave, s: say(text.textContent)};
  });
  sweep(boxes, where, found.figures);
}
const BLOCKS = 'td,th,li,p,dd,dt,figcaption,summary,h1,h2,h4,button,label,nav,footer,header';
const groups = new Map();
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
const range = document.createRange();
for (let node = walker.nextNode(); node; node = walker.nextNode()) {
  const parent = node.parentElement;
  if (!node.data.trim() || parent.closest('svg,script,style,.skip')) continue;
  range.selectNodeContents(node);
  const block = parent.closest(BLOCKS), home = parent.closest('.scroll') || document.body;
  const wall = block && block.getBoundingClientRect();
  for (const r of range.getClientRects()) {
    if (r.width < 1 || r.height < 1) continue;
    found.texts += 1;
    if (wall && (r.left < wall.left - 2 || r.right > wall.right + 2)) found.outside.push(`"${say(node.data)}" leaves its ${block.tagName}`);
    const shave = 0.22 * r.height;
    const box = {l: r.left, r: r.right, t: r.top + shave, b: r.bottom - shave, s: say(node.data)};
    groups.has(home) ? groups.get(home).push(box) : groups.set(home, [box]);
  }
}
for (const box of document.querySelectorAll('.scroll')) {
  const r = box.getBoundingClientRect();
  if (r.width && groups.has(document.body)) groups.get(document.body).push({l: r.left, r: r.right, t: r.top, b: r.bottom, s: '(table)'});
}
for (const [home, boxes] of groups) sweep(boxes, home.getAttribute('aria-label') || 'page', found.overlaps);
return found;
"""

OPEN = """
document.querySelectorAll('details').forEach((d) => { d.open = true; });
document.querySelectorAll('.scroll').forEach((s) => { s.style.maxHeight = 'none'; });
return document.querySelectorAll('details').length;
"""

LINKS = """
const links = [...document.querySelectorAll('a[href^="#"]')];
const ids = [...document.querySelectorAll('[id]')].map((e) => e.id);
return {links: links.length, matrix: document.querySelectorAll('.matrix a.letter').length,
        dead: links.map((a) => a.getAttribute('href').slice(1)).filter((id) => !document.getElementById(id)),
        twice: ids.filter((id, i) => ids.indexOf(id) !== i)};
"""

PARTS = """
return [...document.querySelectorAll('.summary nav a')].map((link) => {
  const part = document.getElementById(link.getAttribute('href').slice(1))?.closest('section');
  return {name: link.textContent, size: part ? part.querySelectorAll('svg.plot, tbody tr, dt, p').length : 0,
          plots: part ? part.querySelectorAll('svg.plot').length : 0};
});
"""

SORT = """
const column = (i) => [...document.querySelectorAll('#all tbody tr')].map((row) => row.cells[i]);
const keys = (i) => column(i).map((c) => 'key' in c.dataset ? (c.dataset.key === '' ? Infinity : +c.dataset.key) : c.textContent.trim().toLowerCase());
const sorted = (list, sign) => list.every((x, i) => !i || (sign * (list[i - 1] > x ? 1 : list[i - 1] < x ? -1 : 0)) <= 0);
const bad = [];
document.querySelectorAll('#all thead th').forEach((head, i) => {
  for (const sign of [1, -1]) {
    head.querySelector('button').click();
    if (!sorted(keys(i), sign)) bad.push(`${head.textContent} ${sign > 0 ? 'up' : 'down'}`);
  }
});
return bad;
"""

FILTER = """
const rows = [...document.querySelectorAll('#all tbody tr')], input = document.getElementById('filter');
const shown = () => rows.filter((row) => row.getBoundingClientRect().height > 0).length;
const type = (text) => { input.value = text; input.dispatchEvent(new Event('input')); return shown(); };
const word = rows[0].cells[2].textContent.trim().toLowerCase();
const chip = document.querySelector('.chips button'), kind = chip.dataset.verdict;
const all = shown(), some = type(word), none = type('no such subject'), again = type('');
chip.click(); const less = shown(); chip.click();
return {all, some, none, again, less, back: shown(), rows: rows.length,
        want: rows.filter((r) => r.textContent.toLowerCase().includes(word)).length,
        others: rows.filter((r) => r.dataset.class !== kind).length};
"""

FOREIGN = """
const script = document.createElement('script');
script.textContent = 'window.foreign = true';
document.body.append(script);
return window.foreign === true;
"""

POINTER = """
const drawing = [...document.querySelectorAll('.drawing')].find((d) => d.querySelector('polyline')), box = drawing.querySelector('svg').getBoundingClientRect();
const at = {clientX: box.left + 0.5 * box.width, clientY: box.top + 0.5 * box.height, bubbles: true};
drawing.dispatchEvent(new PointerEvent('pointermove', at));
return drawing.querySelector('output').textContent;
"""


class Browser:
    """A WebDriver session, as far as this script needs one."""

    def __init__(self):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        self.profile = tempfile.mkdtemp(prefix="browser-")
        self.driver = subprocess.Popen(
            ["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        self.base = f"http://127.0.0.1:{port}"

    def start(self):
        self.wait()
        options = {"args": FLAGS + [f"--user-data-dir={self.profile}"]}
        wanted = {"goog:chromeOptions": options, "goog:loggingPrefs": {"performance": "ALL", "browser": "ALL"}}
        session = self.send("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})
        self.base += "/session/" + session["sessionId"]

    def send(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from error

    def wait(self):
        for _ in range(100):
            try:
                return self.send("GET", "/status")
            except OSError:
                time.sleep(0.1)
        raise RuntimeError("chromedriver does not answer")

    def run(self, script):
        return self.send("POST", "/execute/sync", {"script": script, "args": []})

    def cdp(self, command, **params):
        return self.send("POST", "/goog/cdp/execute", {"cmd": command, "params": params})

    def log(self, kind):
        return self.send("POST", "/se/log", {"type": kind})

    def open(self, url, width, scheme):
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
        self.cdp("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.send("POST", "/url", {"url": url})

    def close(self):
        with contextlib.suppress(RuntimeError, OSError):  # there may be no session
            self.send("DELETE", "")
        self.driver.terminate()
        self.driver.wait()
        shutil.rmtree(self.profile, ignore_errors=True)


class Checks:
    """Counts what holds and says what does not."""

    def __init__(self):
        self.passed = self.failed = 0

    def that(self, holds, name, details=()):
        self.passed += bool(holds)
        self.failed += not holds
        print(f"{'ok    ' if holds else 'FAILED'} {name}", flush=True)
        if not holds:
            details = [details] if isinstance(details, (str, dict)) else list(details)
            for detail in details[:8]:
                print(f"         {detail}")
            if len(details) > 8:
                print(f"         and {len(details) - 8} more")


def look(browser, checks, url):
    """The layout at two widths, in the light and in the dark."""
    grounds = {}
    for width in (1280, 800):
        for scheme in ("light", "dark"):
            browser.open(url, width, scheme)
            opened = browser.run(OPEN)
            browser.send("POST", "/execute/async", {"script": "document.fonts.ready.then(arguments[0])", "args": []})
            name = f"{width} px, {scheme}"
            found = browser.run(LAYOUT)
            size = f"{opened} sections, {found['plots']} plots, {found['texts']} texts"
            checks.that(found["texts"] > 0 and not found["page"], f"{name}: no wider than the window ({size})", found["page"])
            checks.that(not found["figures"], f"{name}: texts in plots are apart and inside", found["figures"])
            checks.that(not found["outside"], f"{name}: texts stay in their boxes", found["outside"])
            checks.that(not found["overlaps"], f"{name}: texts do not overlap", found["overlaps"])
            grounds[scheme] = browser.run("return getComputedStyle(document.body).backgroundColor")
    checks.that(grounds["light"] != grounds["dark"], "the page follows light and dark", grounds)


def use(browser, checks, url):
    """Links, sorting, filtering, values under the pointer."""
    browser.open(url, 1280, "light")
    links = browser.run(LINKS)
    checks.that(links["matrix"] > 0 and not links["dead"], f"{links['links']} links lead somewhere", links["dead"])
    checks.that(not links["twice"], "no id is taken twice", links["twice"])
    parts = browser.run(PARTS)
    checks.that(parts and all(part["size"] for part in parts), f"{len(parts)} parts of the page hold something", parts)
    level = [part["plots"] for part in parts if part["name"] == "p-values"]
    checks.that(level and level[0] > 0, "p-values are drawn", parts)
    bad = browser.run(SORT)
    checks.that(not bad, "every column sorts up and down", bad)
    f = browser.run(FILTER)
    text = f["all"] == f["again"] == f["rows"] and f["some"] == f["want"] and f["none"] == 0
    checks.that(text, f"typing filters: {f['some']} of {f['rows']} rows", f)
    checks.that(f["less"] == f["others"] and f["back"] == f["rows"], f"verdicts filter: {f['less']} rows", f)
    browser.run(OPEN)
    checks.that(":" in browser.run(POINTER), "a plot tells the values under the pointer")
    first = browser.run("return document.querySelector('.matrix a.letter').getAttribute('href')")
    browser.open(url + first, 1280, "light")
    opened = browser.run(f"return document.getElementById({json.dumps(first[1:])}).open")
    checks.that(opened, "a link unfolds the section it leads to", first)


def listen(browser, checks, page):
    """Nothing is asked of a network, and nothing complains."""
    requests = []
    for entry in browser.log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            requests.append(message["params"]["request"]["url"])
    away = [url[:120] for url in requests if not url.startswith(("file:", "data:"))]
    other = [url[:120] for url in requests if url.startswith("file:") and url.split("#")[0] != page]
    checks.that(requests and not away and not other, f"{len(requests)} requests, all for the page itself", away + other)
    errors = [entry["message"][:200] for entry in browser.log("browser") if entry["level"] in ("SEVERE", "WARNING")]
    checks.that(not errors, "the console is silent", errors)
    checks.that(not browser.run(FOREIGN), "no script runs but the page's own")


def without_scripts(browser, checks, url):
    """The tables are there without scripts, and what needs scripts is not."""
    browser.cdp("Emulation.setScriptExecutionDisabled", value=True)
    browser.open(url.split("#")[0], 1280, "light")
    top = browser.cdp("DOM.getDocument", depth=0)["root"]["nodeId"]

    def tall(selector):
        nodes = browser.cdp("DOM.querySelectorAll", nodeId=top, selector=selector)["nodeIds"]
        count = 0
        for node in nodes[:400]:
            try:
                count += browser.cdp("DOM.getBoxModel", nodeId=node)["model"]["height"] > 0
            except RuntimeError:
                pass  # no box: not shown
        return count

    rows, filters, letters = tall("#all tbody tr"), tall(".filter"), tall(".matrix a.letter")
    checks.that(rows > 0 and letters > 0, f"without scripts: {rows} rows and {letters} letters are shown")
    checks.that(filters == 0 and tall(".copy") == 0 and tall(".sort") == 0, "without scripts: no dead controls")
    browser.cdp("Emulation.setScriptExecutionDisabled", value=False)


def main():
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1]).is_file():
        print("usage: browser.py PAGE (an HTML file)", file=sys.stderr)
        return 2
    url = pathlib.Path(sys.argv[1]).resolve().as_uri()
    checks, browser = Checks(), Browser()
    try:
        browser.start()
        browser.send("POST", "/url", {"url": "about:blank"})
        browser.log("performance")  # what the browser's own first page asked for
        look(browser, checks, url)
        use(browser, checks, url)
        listen(browser, checks, url)
        without_scripts(browser, checks, url)
    finally:
        browser.close()
    print(f"{checks.passed} passed, {checks.failed} failed")
    return 1 if checks.failed else 0


if __name__ == "__main__":
    sys.exit(main())
