// A normal that is the mean of twelve drawn bump maps: each is asked point by point, four times for each point.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.39 s, Whittle 0.33 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
plane {
  z, 0
  pigment { rgb .8 }
  normal {
    average
    normal_map {
      #for (I, 1, 12)
        [1 bump_map { function 100, 100 { pattern { bozo scale .05 } } bump_size 3 } translate .01*I*x]
      #end
    }
  }
}
