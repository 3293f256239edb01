// Fine patterns with antialiasing of method 1.
// bench: +W480 +H360 +A0.1
#version 3.7;
#include "textured.inc"
