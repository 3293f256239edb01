// A crank and its pinion as a drawing: tones from cool to warm, and ink where the form ends or turns (words of Whittle's own).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
#default { finish { ambient 0.25 diffuse 0.7 } }

camera { orthographic location <-14, 12, -20> right 4/3*x*8.0 up y*8.0 direction z look_at <0.35, -0.3, -2.2> }
light_source { <-12, 20, -9> rgb 1 }
background { rgb <0.93, 0.90, 0.83> }

#macro Part(C)
  pigment { rgb C }
  #ifdef (Whittle) finish { whittle_cool_warm <0.05, 0.09, 0.22>, <0.36, 0.30, 0.20> whittle_ink 0.03, 26 } #end
#end
#macro Bored(R, Long) cylinder { -Long*z, Long*z, R } #end

// A gear of N teeth about z, flanks cut by planes that lean.
#macro Gear(N, R, Thick)
  difference {
    union {
      cylinder { -Thick*z, Thick*z, R }
      #for (I, 1, N)
        prism { linear_sweep linear_spline -Thick, Thick, 5, <-0.17, 0>, <0.17, 0>, <0.085, 0.36>, <-0.085, 0.36>, <-0.17, 0>
          rotate -90*x scale <1, 1, 1> translate (R - 0.05)*y rotate 360*I/N*z }
      #end
    }
    torus { R*0.62, R*0.17 rotate 90*x translate -Thick*z }
    #for (I, 1, 5) object { Bored(R*0.13, 2) translate R*0.62*y rotate 72*I*z } #end
    Bored(R*0.22, 2)
  }
#end
object { Gear(24, 1.75, 0.32) rotate 4*z translate <-0.4, 0.2, 0.2> Part(<0.70, 0.72, 0.74>) }
object { Gear(11, 0.72, 0.40) rotate 8*z translate <-3.05, 1.0, 0.2> Part(<0.85, 0.60, 0.30>) }
// The shaft with its keyway and collar, drawn out along its axis.
difference {
  union {
    cylinder { -3.6*z, 2*z, 0.36 } cylinder { -1.7*z, -1.2*z, 0.66 } cone { -3.6*z, 0.36, -3.8*z, 0.22 }
  }
  box { <-0.1, 0.2, -3.4>, <0.1, 0.6, -2.1> }
  translate <-0.4, 0.2, -1.2> Part(<0.62, 0.66, 0.72>)
}
// The crank: a web between two eyes, and its handle (lathe).
union {
  difference {
    union {
      cylinder { -0.22*z, 0.22*z, 0.72 } cylinder { -0.22*z, 0.22*z, 0.46 translate <2.9, -1.2, 0> }
      prism { linear_spline -0.15, 0.15, 5, <0, -0.55>, <0, 0.55>, <3.14, 0.36>, <3.14, -0.36>, <0, -0.55> rotate -90*x rotate -22.5*z }
    }
    Bored(0.36, 1)
    object { Bored(0.22, 1) translate <2.9, -1.2, 0> }
  }
  lathe {
    bezier_spline 8, <0, 0>, <0.2, 0>, <0.44, 0.1>, <0.40, 0.6>, <0.40, 0.6>, <0.34, 1.3>, <0.62, 1.9>, <0, 2.0>
    rotate -90*x translate <2.9, -1.2, -0.25>
  }
  translate <-0.4, 0.2, -4.9> Part(<0.80, 0.32, 0.22>)
}
