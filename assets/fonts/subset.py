#!/usr/bin/env python3
"""Makes NotoSansSC-subset.otf: the characters of the locale files, and those of GB 2312 for names that players type.

Usage: subset.py NotoSansCJK-Regular.ttc
The collection is in Debian's package fonts-noto-cjk (1:20220127+repack1-1). Needs fonttools (4.68.0 was used).
"""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTCollection

HERE = Path(__file__).resolve().parent
TARGET = HERE / "NotoSansSC-subset.otf"
FAMILY = "Noto Sans CJK SC"
# Rows of GB 2312, counted from 0xA0: 1 to 3 are punctuation, signs and full-width forms, 16 to 55 the 3755
# commonest characters (level 1), 56 to 87 the 3008 after them (level 2).
ROWS = [*range(1, 4), *range(16, 88)]


def gb_2312():
    """The characters of those rows."""
    for row in ROWS:
        for cell in range(1, 95):
            try:
                yield bytes([0xA0 + row, 0xA0 + cell]).decode("gb2312")
            except UnicodeDecodeError:
                continue


def of_locales():
    """Every character of every locale file; those of other fonts cost little here."""
    for path in sorted((HERE.parent / "locales").glob("*/*.ftl")):
        yield from path.read_text(encoding="utf-8")


def main():
    collection = TTCollection(sys.argv[1], lazy=True)
    font = next(f for f in collection.fonts if f["name"].getDebugName(1) == FAMILY)
    wanted = {c for c in [*gb_2312(), *of_locales()] if c.isprintable()}
    options = subset.Options()
    # What egui does not use: alternative forms, hints, names in other languages.
    options.layout_features = []
    options.hinting = False
    options.desubroutinize = False
    options.notdef_outline = True
    options.name_IDs = [0, 1, 2, 4, 5, 6, 13, 14]
    options.name_languages = [0x409]
    options.drop_tables += ["vhea", "vmtx", "VORG", "BASE", "GSUB", "GPOS", "DSIG"]
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=[ord(c) for c in wanted])
    subsetter.subset(font)
    font["head"].modified = font["head"].created
    font.recalcTimestamp = False
    font.save(TARGET)
    covered = set(font.getBestCmap())
    print(f"{TARGET.name}: {TARGET.stat().st_size} bytes, {len(covered)} characters")


if __name__ == "__main__":
    main()
