"""The pages that the server shows. They load nothing from other hosts."""

from __future__ import annotations

from html import escape
from string import Template

from .access import Refusal

_STUDIO = Template("""\
<!DOCTYPE html>
<html lang="en">
  <head>
    <meta charset="utf-8">
    <title>plastron</title>
    <link rel="icon" href="data:,">
    <link rel="stylesheet" href="/static/css/xterm.css">
    <link rel="stylesheet" href="/own/studio.css">
    <script src="/static/js/textual.js"></script>
    <script src="/own/studio.js"></script>
  </head>
  <body>
    <div class="note" id="opening">
      <p>plastron</p>
      <button type="button" id="start">Start</button>
    </div>
    <div class="note" id="closed">
      <p>The studio has ended.</p>
      <button type="button" id="again">Open it again</button>
    </div>
    <div
      id="terminal"
      class="textual-terminal"
      data-session-websocket-url="$socket"
      data-font-size="$font_size"
    ></div>
  </body>
</html>
""")

_REFUSED = Template("""\
<!DOCTYPE html>
<html lang="en">
  <head>
    <meta charset="utf-8">
    <title>plastron: refused</title>
    <link rel="icon" href="data:,">
  </head>
  <body>
    <h1>Refused: $reason</h1>
    $remedy
  </body>
</html>
""")

_ASK_FOR_TOKEN = """\
<p>Open the URL that <code>plastron serve</code> wrote in its terminal; the token is at its end.
Each run of the server has another one.</p>
    <form action="/" method="get">
      <label>Token: <input name="token" type="password" autocomplete="off" autofocus></label>
      <button>Open the studio</button>
    </form>"""

_MOVING_ON = Template("""\
<!DOCTYPE html>
<html lang="en">
  <head>
    <meta charset="utf-8">
    <title>plastron</title>
    <link rel="icon" href="data:,">
    <meta http-equiv="refresh" content="0; url=$target">
  </head>
  <body><a href="$target">The studio</a></body>
</html>
""")


def studio(socket: str, font_size: int) -> str:
    """Return the page with the terminal, which opens a WebSocket at the address given."""
    return _STUDIO.substitute(socket=escape(socket), font_size=font_size)


def refused(refusal: Refusal, address: str) -> str:
    """Return the page that says why a request was refused.

    Args:
        refusal: why.
        address: where the studio is, without the token.
    """
    where = escape(address)
    if refusal is Refusal.HOST:
        remedy = (
            f"<p>The studio is at <code>{where}</code>. Through a tunnel it is at "
            "<code>127.0.0.1</code> or <code>localhost</code>, with the port at your end.</p>"
        )
    elif refusal is Refusal.ORIGIN:
        remedy = f"<p>Only the studio's own page, at <code>{where}</code>, may use it.</p>"
    else:
        remedy = _ASK_FOR_TOKEN
    return _REFUSED.substitute(reason=escape(refusal.value), remedy=remedy)


def moving_on(target: str) -> str:
    """Return the page that opens another one in its place."""
    return _MOVING_ON.substitute(target=escape(target))
