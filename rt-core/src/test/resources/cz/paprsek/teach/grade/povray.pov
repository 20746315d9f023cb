#version 3.7; global_settings { assumed_gamma 1.0 max_trace_level 4 adc_bailout 0  }
background { rgb <0.05,0.07,0.12> }
#declare D=vnormalize(<0,-0.9,-6>); #declare R=<1,0,0>; #declare U=vnormalize(vcross(R,D));
#declare H=0.8284271247461901;
camera { perspective location <0,1.6,6> direction D up H*U right H*96/64*R }
light_source { <-3,5,4> rgb 1  }
#default { finish { ambient rgb 0.06 } }
plane { y, 0 pigment { rgb <0.55,0.52,0.45> } finish { ambient rgb 0.06 diffuse 0.9 } }
sphere { <-0.9,0.8,0>, 0.8 pigment { rgb <0.75,0.12,0.08> } finish { ambient rgb 0.06 diffuse 0.8 phong 0.3 phong_size 30 } }
sphere { <1,0.6,0.6>, 0.6 pigment { rgb <0.1,0.25,0.6> } finish { ambient rgb 0.06 diffuse 0.6 phong 0.5 phong_size 60 reflection 0.25 } }
