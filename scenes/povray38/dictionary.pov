#version 3.8;
// Solids and their colours by name, in a dictionary that holds others.
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at 0 angle 45 }
light_source { <-4, 6, -6>, 1 }

#declare Kind = dictionary {
    .Ball: dictionary { .Shape: sphere { 0, 0.8 }, .Colour: rgb <0.9, 0.3, 0.2>, .Place: -1.8 },
    .Block: dictionary { .Shape: box { -0.6, 0.6 }, .Colour: rgb <0.2, 0.6, 0.9>, .Place: 0 }
}
#declare Kind["Cone"] = dictionary { .Shape: cone { -0.7*y, 0.7, 0.8*y, 0 } .Place: 1.8 }
#declare Kind.Cone.Colour = rgb <0.3, 0.8, 0.3>;
#declare Names = array[3] { "Ball", "Block", "Cone" }

#for (I, 0, 2)
    #local One = Kind[Names[I]];
    object { One.Shape pigment { One.Colour } translate One.Place*x }
#end
#ifndef (Kind.Torus) plane { y, -1 pigment { rgb 0.6 } } #end
