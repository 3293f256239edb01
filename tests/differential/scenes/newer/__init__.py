"""Classes of scenes for POV-Ray 3.8."""
