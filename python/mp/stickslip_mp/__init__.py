"""The compiled part of high precision and enclosures; `stickslip` calls it."""
