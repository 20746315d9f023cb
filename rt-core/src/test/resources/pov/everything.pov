// Everything
// povray +Iscene.pov +W64 +H48 -A +FN16 File_Gamma=1.0 +Oscene.png writes 16-bit linear light, one ray a pixel.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 9 adc_bailout 0 ambient_light rgb <1, 0, 0> }
background { rgb <0.006995410187265387, 0.10702310297826761, 0.4793201831008268> }
camera { perspective location <0, 2, 8> direction <0, 0, -1> up <0, 1.9999999999999998, 0> right image_width/image_height*<1.9999999999999998, 0, 0> }
// key
light_source { <4, 5, 3>, rgb <0.5, 0.5, 0> }
#declare Material_1_steelco = texture { pigment { rgb <1, 1, 1> } finish { ambient 1 diffuse 0.3 phong 0.6 phong_size 100 reflection 0.5 } }
#declare Material_2_glass = texture { pigment { rgb <0, 1, 1> transmit 0.75 } finish { ambient 4 diffuse 0.4 reflection 0.25 } }
// ball
sphere { <0, 0, 0>, 0.5 texture { Material_1_steelco } translate <0, 0.5, 0> }
box { <0, 0, 0>, <1, 2, 3> texture { pigment { rgb <1, 1, 1> } finish { ambient 1 diffuse 0.8 } } scale 2 rotate <10, 20, 30> }
sphere { <0, 0, 0>, 1 scale <1, 2, 3> texture { pigment { checker rgb <1, 1, 1> rgb <1, 0, 0> scale 0.5 translate <1, 2, 3> } finish { ambient 1 diffuse 0.8 } } scale <1, 2, 1> }
plane { y, 0 texture { pigment { rgb <1, 1, 1> } finish { ambient 1 diffuse 0.8 } } translate <0, -1, 0> }
cylinder { <0, 0, 0>, <0, 2, 0>, 1 texture { pigment { rgb <1, 1, 1> } finish { ambient 1 diffuse 0.8 } } }
cone { <0, 0, 0>, 1, <0, 2, 0>, 0 texture { pigment { rgb <1, 1, 1> } finish { ambient 1 diffuse 0.8 } } }
torus { 2, 0.5 sturm texture { pigment { rgb <1, 1, 1> } finish { ambient 1 diffuse 0.8 } } }
polygon { 5, <-1, -2, 0>, <1, -2, 0>, <1, 2, 0>, <-1, 2, 0>, <-1, -2, 0> texture { pigment { checker rgb <1, 1, 1> rgb <0, 0, 0> scale <0.5, 2, 1000000> translate <-1, -2, -500000> } finish { ambient 1 diffuse 0.8 } } }
disc { <0, 0, 0>, z, 2 texture { pigment { checker rgb <1, 1, 1> transmit 0.5 rgb <0, 0, 0> transmit 0.5 scale <1, 2, 1000000> translate <-2, -2, -500000> } finish { ambient 2 diffuse 1.6 } } }
merge {
  // left
  sphere { <0, 0, 0>, 1 }
  difference {
    sphere { <0, 0, 0>, 1 }
    box { <0, 0, 0>, <1, 1, 1> texture { pigment { rgb <1, 1, 1> } finish { ambient 1 diffuse 0.5 } } }
    translate <1, 0, 0>
  }
  object {
    sphere { <0, 0, 0>, 3 texture { pigment { rgb <1, 1, 1> transmit 0.9999990463256836 } finish { ambient 1048576 diffuse 838860.8 } } }
  }
  texture { Material_2_glass } interior { ior 1.5 }
}
