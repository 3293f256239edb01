#pragma once

#include "csg/tree/program.h"  // csg::Scratch: what one thread needs to answer rays; reused, never shared
