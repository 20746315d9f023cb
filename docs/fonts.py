"""Makes the fonts that are shipped (rt-core/src/main/resources/cz/paprsek/shape/font) of DejaVu 2.37: Latin letters, no hints, kerning as a kern table.

    pip install fonttools
    python docs/fonts.py FOLDER_OF_DEJAVU rt-core/src/main/resources/cz/paprsek/shape/font
"""
import sys
from fontTools import subset
from fontTools.ttLib import TTFont

LETTERS = [*range(0x20, 0x7F), *range(0xA0, 0x180), 0x218, 0x219, 0x21A, 0x21B, *map(ord, "–—‘’‚“”„†•…‰‹›€™←↑→↓−√∞≈≠≤≥★♥✓πΩμ")]
# What formulas of worksheets are written with.
MATHS = [*map(ord, "αβγδεηθλνρσςτφωΔΣΠ⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺ⁿⁱ₀₁₂₃₄₅₆₇₈₉ₙₑₓ′″∥⊥∈⌊⌋⌈⌉·×÷±∓∂∇∑∏⇒⇔½¼¾⅓⅛›│├└─□▪…")]
FONTS = {"DejaVuSans": "sans", "DejaVuSans-Bold": "sans-bold", "DejaVuSerif": "serif"}

source, target = sys.argv[1:]
for file, name in FONTS.items():
    font = TTFont(f"{source}/{file}.ttf", recalcTimestamp=False)
    options = subset.Options(hinting=False, glyph_names=False, legacy_kern=True, name_IDs=[0, 13, 14], notdef_outline=True, drop_tables=[
        "FFTM", "GDEF", "GPOS", "GSUB", "MATH", "gasp", "OS/2"])
    cut = subset.Subsetter(options)
    cut.populate(unicodes=LETTERS + (MATHS if name.startswith("sans") else []))
    cut.subset(font)
    # Its licence asks for another name only of what is called Bitstream or Vera; all the same this is not DejaVu as others know it.
    for number, text in ((1, f"Paprsek {name}"), (2, "Regular"), (4, f"Paprsek {name}"), (6, f"Paprsek-{name}"), (5, "Version 2.37, a part of DejaVu")):
        font["name"].setName(text, number, 3, 1, 0x409)
    font.save(f"{target}/{name}.ttf", reorderTables=True)
