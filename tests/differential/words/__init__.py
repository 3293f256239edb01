"""Words that the classes of scenes share: patterns, statements, expressions, procedures."""
