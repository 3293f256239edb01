"""The rules of axe-core (accessibility of web pages) over the page of `whittle watch`, in a real browser.

usage: axe.py WHITTLE [--shots FOLDER]     exit status 0: no finding, 77: no browser, or one without axe-core

Chromium carries axe-core for the audits of its own tools: that is what runs here. With the newest there is:
npm install axe-core && WHITTLE_AXE=node_modules/axe-core/axe.min.js tests/watch/axe.py build/release/whittle
"""
import os
import sys

import browser
from access import LOOKS, TALL, states
from watched import NO_BROWSER, asked

AUDITS = "devtools://devtools/bundled/third_party/lighthouse/lighthouse-dt-bundle.js"
# The contrast of lines that are scrolled out of sight it leaves undecided: `access.py` has that of all texts.
RUN = """axe.run(document, { elementRef: true, runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] }).then(r => {
  const told = (kind, list) => list.map(v => `${kind} ${v.id}, ${v.help}: ` + v.nodes.map(n => n.html.slice(0, 120)).join(' | '));
  for (const v of r.incomplete) if (v.id === 'color-contrast') v.nodes = v.nodes.filter(n => !n.element.closest('.wide'));
  r.incomplete = r.incomplete.filter(v => v.nodes.length);
  return { version: r.testEngine.version, held: r.passes.map(v => v.id), found: [...told('broken:', r.violations), ...told('undecided:', r.incomplete)] };
})"""
# Rules that have to have found something to judge: a run that sees nothing would prove nothing.
HELD = {"color-contrast", "button-name", "label", "landmark-one-main", "page-has-heading-one", "region", "html-has-lang", "document-title",
        "target-size", "select-name", "heading-order"}


def library():
    """A script that defines `axe`; None: there is none."""
    if os.environ.get("WHITTLE_AXE"):
        with open(os.environ["WHITTLE_AXE"]) as file:
            return file.read()
    with browser.Browser() as page:
        try:
            page.open("devtools://devtools/bundled/inspector.html")
        except RuntimeError:
            return None
        # It stands in there as one literal of a text.
        literal = page.ask(f"fetch('{AUDITS}').then(r => r.text()).then(t => (t.match(/`\\/\\*! axe v(?:[^`\\\\]|\\\\.)*`/s) || [''])[0], () => '')")
    return f"(0, eval)({literal})" if literal else None


def main():
    arguments = asked()
    if not arguments:
        return NO_BROWSER
    axe = library()
    if not axe:
        print("this browser has no axe-core")
        return NO_BROWSER
    for state, seen, ready in states(os.path.abspath(arguments.whittle), arguments.shots):
        page = seen.page
        ready()
        page.call("Runtime.evaluate", expression=axe)
        for width, scheme in LOOKS:
            page.size(width, TALL)
            page.scheme(scheme)
            result = page.ask(RUN)
            assert not result["found"], (state, width, scheme, result["found"])
            held = HELD if state == "well" else HELD - {"label", "select-name"}
            assert held <= set(result["held"]), held - set(result["held"])
            print(f"{state}, {width} pixels wide, {scheme}: {len(result['held'])} rules of axe {result['version']} hold")
    print("passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
