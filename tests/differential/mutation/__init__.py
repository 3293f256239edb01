"""Changes of scene texts: of numbers, words and blocks."""
