"""Colours of the pictures of robots."""

from __future__ import annotations

from .shades import DARKEST

OPACITY = 0.88
"""Of bodies: one sees what is behind them."""

PLAIN_SHADES = 8
"""How many shades darker than straight on what has no colour can be."""


def _plain(red: int, green: int, blue: int) -> str:
    """Return the rules of what has no colour, from edge-on to straight on."""
    rules = []
    for at in range(PLAIN_SHADES + 1):
        bright = DARKEST + (1 - DARKEST) * at / PLAIN_SHADES
        parts = ",".join(str(round(part * bright)) for part in (red, green, blue))
        rules.append(f".robot .p{at}{{fill:rgb({parts})}}")
    return "\n".join(rules)


# What has a colour of its own says it inline; all else follows the scheme.
STYLE = f"""<style>
.robot text{{text-anchor:start}}
.robot .head{{font-size:15px;font-weight:600;fill:#1d2733}}
.robot .link{{font-size:12.5px;font-weight:600;fill:#1d2733}}
.robot .said{{font-size:10.5px;fill:#5d6b7a}}
.robot .joint{{font-size:10.5px;fill:#7a52c7}} .robot .firm{{font-size:10.5px;fill:#5d6b7a}}
.robot .plain{{fill:#a9b8c7}}
{_plain(0xA9, 0xB8, 0xC7)}
.robot .body{{opacity:{OPACITY}}}
.robot .edge{{stroke:#1d2733;stroke-opacity:.62;stroke-width:.9;stroke-linejoin:round}}
.robot .box .edge{{stroke-dasharray:4 2.5}}
.robot .unknown{{fill:#fbfcfd;stroke:#5d6b7a;stroke-width:1.2}}
.robot .bone{{stroke:#9aa7b5;stroke-width:1.2;stroke-dasharray:1.5 2.5}}
.robot .rail{{fill:none;stroke:#9aa7b5;stroke-width:1.4}}
.robot .moves{{stroke:#9a7ad6;stroke-width:2}}
.robot .spot{{stroke:#5d6b7a;stroke-width:1}}
.robot .none{{fill:none}}
.robot .halo{{stroke:#fbfcfd;stroke-width:4.5;stroke-opacity:.6}}
.robot .axis{{fill:none;stroke:#7a52c7;stroke-width:1.8}}
.robot .tip{{fill:#7a52c7}}
.robot .end{{fill:#fbfcfd;stroke:#7a52c7;stroke-width:1.5}}
.robot .lead{{stroke:#7a52c7;stroke-width:.7;stroke-opacity:.75}}
.robot .name{{font-size:10.5px;fill:#5a34a6}}
.robot .name,.robot .xyz{{paint-order:stroke;stroke:#fbfcfd;stroke-width:3px;stroke-linejoin:round}}
.robot .xyz{{font-size:10.5px;font-weight:600}}
.robot .x{{fill:#c9473a}} .robot .y{{fill:#38946a}} .robot .z{{fill:#4a78c2}}
.robot path.x,.robot path.y,.robot path.z{{fill:none;stroke-width:1.6}}
.robot path.x{{stroke:#c9473a}} .robot path.y{{stroke:#38946a}} .robot path.z{{stroke:#4a78c2}}
.robot .rule{{fill:none;stroke:#5d6b7a;stroke-width:1.3}}
.robot .alarm{{font-size:10.5px;fill:#b3362a}}
@media (prefers-color-scheme:dark){{
.robot .head,.robot .link{{fill:#e8edf3}} .robot .said,.robot .firm{{fill:#9dabba}}
.robot .joint{{fill:#b99cf2}}
.robot .plain{{fill:#7d8c9c}}
{_plain(0x7D, 0x8C, 0x9C)}
.robot .edge{{stroke:#f0f4f8;stroke-opacity:.55}}
.robot .unknown{{fill:#161b22;stroke:#9dabba}}
.robot .bone,.robot .rail{{stroke:#5d6b7a}} .robot .moves{{stroke:#8a6bc4}}
.robot .spot{{stroke:#c3ced9}}
.robot .halo{{stroke:#161b22}} .robot .axis{{stroke:#b08cf0}} .robot .tip{{fill:#b08cf0}}
.robot .end{{fill:#161b22;stroke:#b08cf0}} .robot .lead{{stroke:#b08cf0}}
.robot .name{{fill:#d3c0fb}}
.robot .name,.robot .xyz{{stroke:#161b22}}
.robot .x{{fill:#ff7b6b}} .robot .y{{fill:#54bd8c}} .robot .z{{fill:#6c9be6}}
.robot path.x{{stroke:#ff7b6b}} .robot path.y{{stroke:#54bd8c}} .robot path.z{{stroke:#6c9be6}}
.robot .rule{{stroke:#9dabba}}
.robot .alarm{{fill:#ff8f80}}
}}
</style>"""
