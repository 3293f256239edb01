// Fine patterns with recursive antialiasing.
// bench: +W320 +H240 +A0.1 +AM2
#version 3.7;
#include "textured.inc"
