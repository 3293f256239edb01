// A pocket watch, opened, the drawing of its largest wheel, a pencil, and a glass bell over a spare arbor.
// The picture of the project's README: solids cut out of each other, engraved letters, metal, jewels, glass.
// A unit is about a millimetre. The watch lies in the xz plane, its middle in the origin.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 adc_bailout 0.03 }
#default { finish { ambient 0 } }

camera { location <4.6, 39, -46> look_at <4.9, 0, 1.7> right 1.5*x angle 38 }

// ---- light: a soft warm key from the left, a cool one overhead, a little from behind the camera

#macro SoftBox(Middle, Width, Height, Colour, Lamps, Levels)
  #local Side = vnormalize(vcross(y, -Middle));
  light_source {
    Middle, Colour
    area_light Side*Width, vnormalize(vcross(-Middle, Side))*Height, Lamps, Lamps adaptive Levels
    spotlight point_at <3, 0, 0> radius 8 falloff 30 tightness 0
  }
#end
SoftBox(<-48, 50, 8>, 26, 26, rgb <1.00, 0.90, 0.76>*1.1, 9, 2)
SoftBox(<14, 80, 26>, 30, 24, rgb <0.72, 0.86, 1.00>*0.45, 5, 1)
light_source { <10, 40, -60> rgb <0.75, 0.88, 1.00>*0.10 shadowless }

// What metal and glass mirror: a bright band on a wall out of the picture, the key's box, a strip on the right.
#declare Card = finish { emission 1 diffuse 0 }
#declare Square = polygon { 5, <-0.5, -0.5>, <0.5, -0.5>, <0.5, 0.5>, <-0.5, 0.5>, <-0.5, -0.5> no_image no_shadow }
object {
  Square scale <150, 100, 1> translate <0, 54, 75>
  pigment {
    gradient x
    color_map {
      [0.28 rgb <0.07, 0.08, 0.09>] [0.40 rgb <0.26, 0.28, 0.31>] [0.51 rgb <0.80, 0.77, 0.73>]
      [0.58 rgb <1.05, 0.98, 0.90>] [0.66 rgb <0.80, 0.77, 0.74>] [0.76 rgb <0.18, 0.21, 0.25>]
      [1.00 rgb <0.03, 0.04, 0.05>]
    }
    scale 110 translate -55*x rotate -24*z translate <-8, 60, 0>
  }
  finish { Card }
}
object {
  Square scale 32 rotate <0, -90, 45> translate <-52, 54, 8>
  pigment { rgb <1.20, 1.08, 0.92> } finish { Card }
}
object {
  Square scale <60, 24, 1> rotate 90*y translate <70, 26, 10>
  pigment { rgb <0.55, 0.68, 0.80> } finish { Card }
}
sky_sphere {
  pigment {
    gradient y
    color_map { [0 rgb <0.02, 0.025, 0.03>] [0.5 rgb <0.06, 0.08, 0.10>] [1 rgb <0.25, 0.29, 0.34>] }
  }
}

// ---- materials

#macro Metal(Colour, Matte, Mirror, Rough)
  pigment { rgb Colour }
  finish { diffuse Matte specular 0.6 roughness Rough metallic reflection { Mirror metallic } }
#end
#declare Steel = texture { Metal(<0.70, 0.72, 0.75>, 0.16, 0.80, 0.010) }
#declare Polished = texture { Metal(<0.92, 0.90, 0.87>, 0.08, 0.92, 0.004) }
#declare Gold = texture { Metal(<1.00, 0.70, 0.34>, 0.20, 0.72, 0.012) }
#declare RoseGold = texture { Metal(<1.00, 0.69, 0.47>, 0.16, 0.74, 0.006) }
#declare Blued = texture { Metal(<0.03, 0.07, 0.32>, 0.30, 0.80, 0.008) }
#declare Enamel = texture { pigment { rgb <0.012, 0.018, 0.035> } finish { diffuse 0.8 specular 0.2 roughness 0.02 } }
#declare Striped = texture {  // as a wheel leaves it that is drawn across again and again
  Metal(<0.76, 0.74, 0.71>, 0.13, 0.80, 0.030)
  normal { gradient x 0.36 slope_map { [0 <0, 1>] [0.5 <0.25, 0>] [1 <0, -1>] } scale 1.3 rotate -28*y }
}
#declare Turned = texture {  // rings of a lathe
  Metal(<0.74, 0.74, 0.75>, 0.18, 0.74, 0.020)
  normal { wood 0.12 scallop_wave rotate 90*x scale 0.35 }
}
// Circles that overlap, each left by a turning peg: the later one is seen, where it reaches.
#declare Fold = function(U) { U - floor(U) }
#declare Ring = function(U, V) { sqrt(U*U + V*V) }
#declare Pegs = function(U, V) { select(Ring(U - 1, V - 0.5) - 0.68, Ring(U - 1, V - 0.5), Ring(U, V - 0.5)) }
#declare Pearled = texture {
  Metal(<0.90, 0.84, 0.74>, 0.25, 0.60, 0.030)
  normal { function { Pegs(Fold(x/0.7), Fold(z/0.7)) } 0.3 }
}
#declare Ruby = material {
  texture {
    pigment { rgbf <0.95, 0.06, 0.14, 0.86> }
    finish { diffuse 0.25 specular 1 roughness 0.002 reflection { 0.02, 1 fresnel } conserve_energy }
  }
  interior { ior 1.76 }
}
#declare Glass = material {
  texture {
    pigment { rgbf <0.96, 0.985, 0.98, 0.97> }
    finish { diffuse 0 reflection { 0.01, 1 fresnel } conserve_energy }
  }
  interior { ior 1.5 }
}

// ---- parts

// A disc whose upper edge is bevelled: cylinder, cone and plane leave their own textures on what they cut.
#macro Bevelled(R, Bottom, Top, Bevel, Edge)
  intersection {
    cylinder { Bottom*y, (Top + 1)*y, R texture { Edge } }
    cone { (Top - Bevel - 2)*y, R + 2, (Top - Bevel + R)*y, 0 texture { Polished } }
  }
#end
#macro Disc(R, Bottom, Top, Bevel, Face, Edge)
  intersection {
    Bevelled(R, Bottom, Top, Bevel, Edge)
    plane { y, Top texture { Face } }
  }
#end

// What a drill with a countersink takes away, and what a cutter with a V takes along x.
#macro Drill(R, Top, Bevel)
  union {
    cylinder { -5*y, (Top + 1)*y, R }
    cone { (Top - Bevel)*y, R, (Top + 1)*y, R + Bevel + 1 }
    texture { Polished }
  }
#end
#macro Groove(Long, Wide, Top, Bevel)
  #local W = Wide/2;
  prism {
    0, Long, 7, <-W, -5>, <W, -5>, <W, Top - Bevel>, <W + Bevel + 1, Top + 1>, <-W - Bevel - 1, Top + 1>,
    <-W, Top - Bevel>
    <-W, -5>
    rotate <-90, -90, 0>
    texture { Polished }
  }
#end

// An arm from A to B with round ends, its edge bevelled all around.
#macro Arm(A, RA, B, RB, Bottom, Top, Bevel, Face)
  #local Long = vlength(B - A);
  #local Tilt = degrees(asin((RA - RB)/Long));  // of the sides, which touch both ends
  intersection {
    union {
      Bevelled(RA, Bottom, Top, Bevel, Steel)
      object { Bevelled(RB, Bottom, Top, Bevel, Steel) translate Long*x }
      intersection {
        box { <RA*sin(radians(Tilt)), Bottom, -RA - RB>, <Long + RB*sin(radians(Tilt)), Top + 1, RA + RB> }
        #for (S, -1, 1, 2)
          plane { S*z, RA rotate S*Tilt*y }
          plane { y + S*z, 0 translate <0, Top - Bevel, S*RA> rotate S*Tilt*y texture { Polished } }
        #end
        texture { Steel }
      }
    }
    plane { y, Top texture { Face } }
    rotate -degrees(atan2(B.z - A.z, B.x - A.x))*y
    translate A
  }
#end

// A toothed wheel about the y axis; its teeth reach from Root to Tip. Corners are numbered around, four a tooth.
#declare Beside = array[4] { -0.29, -0.09, 0.09, 0.29 }  // of a tooth's middle, in teeth
#macro Corner(I, Teeth, Root, Tip)
  #local J = mod(I, 4);
  #local R = (J = 1 | J = 2 ? Tip : Root);
  #local Angle = (div(I, 4) + Beside[J])*2*pi/Teeth;
  <R*cos(Angle), R*sin(Angle)>
#end
#macro Wheel(Teeth, Root, Tip, Rim, Arms, Hub, Thick, Finish)
  union {
    difference {
      prism {
        0, Thick, Teeth*4 + 1
        #for (I, 0, Teeth*4 - 1) Corner(I, Teeth, Root, Tip), #end
        Corner(0, Teeth, Root, Tip)
      }
      cylinder { -y, (Thick + 1)*y, Rim }
    }
    #for (I, 0, Arms - 1)
      box { <0, 0.02, -0.09*Root>, <Rim + 0.05, Thick - 0.02, 0.09*Root> rotate 360*I/Arms*y }
    #end
    cylinder { 0, (Thick + 0.08)*y, Hub }
    texture { Finish }
  }
#end

// A domed screw with its slot turned.
#macro Screw(Place, R, Turn)
  difference {
    intersection {
      cylinder { -0.3*y, y, R }
      sphere { -1.3*R*y, 1.6*R }
    }
    box { <-R*2, 0.06*R, -R*0.16>, <R*2, 1, R*0.16> }
    texture { Blued }
    rotate Turn*y
    translate Place
  }
#end

// A pierced jewel in a gold setting, and the pivot that turns in it.
#macro Jewel(Place, R)
  union {
    difference {
      Disc(R*1.75, -0.5, 0.10, 0.06, Gold, Gold)
      cylinder { -0.2*y, y, R*1.02 texture { Gold } }
    }
    difference {
      cylinder { -0.2*y, 0.06*y, R }
      sphere { 0, R*0.62 scale <1, 0.5, 1> translate 0.06*y }
      material { Ruby }
    }
    cylinder { -0.2*y, 0.02*y, R*0.22 texture { Steel } }
    translate Place
  }
#end

// Letters on a circle about the origin, over its top from left to right, from Bottom up.
#macro Lettering(Words, R, Size, Spread, Bottom)
  #local Angle = 0;
  union {
    #for (I, 1, strlen(Words))
      #if (strcmp(substr(Words, I, 1), " ") = 0)
        #local Angle = Angle + degrees(0.4*Size/R);
      #else
        #local Letter = text { ttf "timrom.ttf", substr(Words, I, 1), 1, 0 scale <Size, Size, 1> }
        #local Low = min_extent(Letter);
        #local High = max_extent(Letter);
        #local Half = degrees((High.x - Low.x)/2/R);
        object {
          Letter
          bounded_by { box { Low, High } }
          translate -(Low.x + High.x)/2*x
          rotate 90*x
          translate <0, Bottom + 1, R>
          rotate (Angle + Half)*y
        }
        #local Angle = Angle + 2*Half + degrees(Spread*Size/R);
      #end
    #end
    bounded_by { box { <-R, Bottom, 0>, <R, Bottom + 1, R + Size> } }
    texture { Enamel }
    rotate -(Angle - degrees(Spread*Size/R))/2*y
  }
#end

// ---- the watch

#declare Top = 3.0;  // of the bridges
#declare Balance = <3.6, 0, -4.4>;
#declare Window = <-4.6, 0, -4.3>;
#declare Ratchet = <-3.4, Top, 3.0>;
#declare CrownWheel = <2.0, Top, 4.97>;

// the case, the main plate, the bridges
difference {
  torus { 11.7, 1.75 scale <1, 1.05, 1> translate 1.75*y }
  cylinder { -y, 5*y, 10.5 }
  cone { 2.75*y, 10.5, 4*y, 11.75 }
  texture { RoseGold }
}
torus { 10.95, 0.16 translate 3.24*y texture { RoseGold } }
difference {
  cylinder { 0.6*y, 1.5*y, 10.49 }
  cylinder { y, 2*y, 3.3 translate Balance }
  texture { Pearled }
}
difference {
  Disc(9.9, 2.1, Top, 0.22, Striped, Steel)
  object { Drill(3.75, Top, 0.22) translate Balance }
  object { Drill(2.9, Top, 0.22) translate Window }
  object { Groove(12, 0.12, Top, 0.17) rotate 184*y translate <-0.35, 0, -1.02> }
  cylinder { (Top - 0.25)*y, 5*y, 3.95 translate Ratchet*<1, 0, 1> texture { Turned } }
  object { Lettering("WHITTLE", 4.75, 1.55, 0.10, Top - 0.10) rotate 3*y translate Balance }
  object { Lettering("CUT AS WRITTEN", 6.4, 0.66, 0.12, Top - 0.07) rotate 3*y translate Balance }
}

// the winding wheels, and the train below the window
object { Wheel(56, 3.32, 3.64, 2.9, 0, 2.95, 0.42, Turned) translate Ratchet }
object { Wheel(36, 2.07, 2.39, 1.6, 0, 1.65, 0.42, Turned) rotate 3*y translate CrownWheel }
object { Wheel(60, 2.35, 2.6, 1.95, 5, 0.5, 0.24, Gold) rotate 20*y translate Window + <-0.25, 2.05, -0.1> }
object { Wheel(70, 2.9, 3.15, 2.5, 5, 0.6, 0.22, Gold) translate Window + <2.9, 1.6, 0.9> }
object { Wheel(10, 0.35, 0.62, 0.2, 0, 0.25, 1.0, Steel) translate Window + <-0.25, 1.55, -0.1> }

// the balance: a rim with its screws, two arms, a spring of half circles, and the cock above
union {
  difference { cylinder { 2.0*y, 2.45*y, 3.0 } cylinder { y, 3*y, 2.62 } }
  box { <-2.7, 2.1, -0.24>, <2.7, 2.3, 0.24> }
  cylinder { 2.0*y, 2.4*y, 0.6 }
  #for (I, 0, 15) cylinder { 2.95*x, 3.28*x, 0.17 rotate 22.5*(I + 0.5)*y translate 2.22*y } #end
  texture { Gold }
  rotate 24*y
  translate Balance
}
union {
  #for (I, 0, 15)
    #local Even = mod(I + 1, 2);
    intersection {
      cylinder { 2.5*y, 2.72*y, 0.48 + 0.11*I }
      cylinder { 2.4*y, 2.8*y, 0.42 + 0.11*I inverse }
      plane { (2*Even - 1)*z, 0 }
      translate (1 - Even)*0.11*x
    }
  #end
  texture { Blued }
  translate Balance
}
Arm(<8.2, 0, -3.3>, 1.45, Balance, 0.95, 2.9, 3.6, 0.18, Striped)
Jewel(Balance + 3.6*y, 0.36)
Screw(<8.2, 3.6, -3.3>, 0.66, 70)

Jewel(<-0.85, Top, -2.9>, 0.34)
Jewel(<-0.9, Top, -5.4>, 0.30)
Jewel(<-0.4, Top, -7.6>, 0.26)
Jewel(<8.2, Top, 2.8>, 0.34)
Screw(Ratchet + 0.5*y, 1.1, 30)
Screw(CrownWheel + 0.5*y, 0.8, -55)
Screw(<-8.6, Top, -2.0>, 0.55, 20)
Screw(<-8.7, Top, 1.0>, 0.55, 100)
Screw(<-5.6, Top, 7.2>, 0.55, 40)
Screw(<4.9, Top, 7.8>, 0.55, 75)
Screw(<9.0, Top, 0.4>, 0.55, -30)
Screw(<-2.4, Top, -8.8>, 0.48, 10)

// stem, crown and bow
union {
  cylinder { 10*x, 15*x, 1.0 }
  difference {
    cylinder { 14.6*x, 17*x, 1.7 }
    #for (I, 0, 23) cylinder { 14*x, 18*x, 0.14 translate 1.75*y rotate 15*I*x } #end
  }
  torus { 3.3, 0.42 translate 16.4*x }
  texture { RoseGold }
  rotate -142*y
  translate 1.75*y
}

// ---- the sheet with its drawing

#declare Ground = rgb <0.038, 0.098, 0.112>;
#declare Grid = rgb <0.075, 0.155, 0.170>;
plane {
  y, 0
  pigment {
    gradient x
    pigment_map { [0.015 Grid] [0.015 gradient z color_map { [0.015 Grid] [0.015 Ground] }] }
    scale 2
    rotate -24*y
  }
  finish { diffuse 0.9 specular 0.05 roughness 0.06 }
}
#declare Ink = texture { pigment { rgb <0.40, 0.56, 0.60> } finish { diffuse 0.9 } }
#declare Laid = transform { rotate -24*y translate <16.5, 0, -8> }
#macro Stroke(P, Q) cylinder { P.x*x + P.y*z, Q.x*x + Q.y*z, 0.035 texture { Ink } no_shadow transform { Laid } } #end
#for (I, 0, 223)
  Stroke(Corner(I, 56, 5.98, 6.55), Corner(I + 1, 56, 5.98, 6.55))
#end
#for (I, 0, 2)
  #local R = 0.9 + 0.8*I + 0.8*I*I;
  disc { 0.02*y, y, R + 0.03, R - 0.03 texture { Ink } no_shadow transform { Laid } }
#end
Stroke(<-8, 0>, <8, 0>)
Stroke(<0, -8>, <0, 8>)

// ---- the pencil: a hexagon meets a cone, and the lacquer ends in six arcs

intersection {
  #for (I, 0, 5) plane { y, 0.85 rotate 60*I*x } #end
  plane { x, 40 }
  cone {
    0, 0.08, 60*x, 15.6
    pigment { cylindrical rotate 90*z color_map { [0.72 rgb <0.72, 0.50, 0.30>] [0.72 rgb <0.05, 0.05, 0.055>] } }
    finish { diffuse 0.8 specular 0.2 roughness 0.05 }
  }
  bounded_by { box { <0, -1, -1>, <40, 1, 1> } }
  pigment { rgb <0.42, 0.03, 0.045> }
  finish { diffuse 0.8 specular 0.7 roughness 0.01 reflection { 0.10, 0.8 falloff 3 } }
  translate 0.85*y
  rotate 52*y
  translate <16.2, 0, -7.4>
}

// ---- the bell and what it keeps from dust

union {
  difference {
    merge {
      cylinder { 0.01*y, 4*y, 4.7 }
      sphere { 4*y, 4.7 }
      cylinder { 8.4*y, 9.3*y, 0.42 }
      sphere { 9.7*y, 0.75 }
    }
    cylinder { -y, 4*y, 4.45 }
    sphere { 4*y, 4.45 }
    material { Glass }
    no_shadow
  }
  Disc(3.6, 0, 0.5, 0.2, Gold, Gold)
  cylinder { 0.1*y, 6*y, 0.2 texture { Gold } }
  object { Wheel(10, 0.55, 0.9, 0.3, 0, 0.4, 1.2, Steel) translate 1.3*y }
  object { Wheel(60, 2.95, 3.25, 2.5, 5, 0.6, 0.3, Gold) rotate 11*y translate 3.4*y }
  sphere { 6.2*y, 0.42 material { Ruby } }
  translate <18.6, 0, 10.5>
}
