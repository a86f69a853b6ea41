# The balls as other programs read them: awk -v to=povray|tachyon -f balls_for_others.awk scenes/balls5.ray
# View, light, colours, highlights and mirrors are those of the file; so is the depth of 5 mirrors. Tachyon's coordinates are
# left-handed: x and y are swapped for it.
BEGIN {
  if (to == "povray") {
    print "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0.002 }"
    print "camera { location <2.1,1.3,1.7> sky z up y right -x angle 45 look_at 0 }"
    print "background { rgb <.078,.361,.753> }\nlight_source { <4,3,2> rgb 1 }"
    print "#declare Dull = texture { pigment { rgb <.5,.45,.35> } finish { ambient 0 diffuse 1 phong .5 phong_size 3.0827 } }"
    print "#declare Shiny = texture { Dull finish { ambient 0 diffuse 1 phong .5 phong_size 3.0827 reflection { .25 } } }"
  } else {
    print "BEGIN_SCENE\nRESOLUTION 96 96"
    print "CAMERA PROJECTION PERSPECTIVE ZOOM 1.2071068 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 6"
    print "CENTER 1.3 2.1 1.7 VIEWDIR -1.3 -2.1 -1.7 UPDIR 0 0 1 END_CAMERA"
    print "BACKGROUND .078 .361 .753\nLIGHT CENTER 3 4 2 RAD .0001 COLOR 1 1 1"
    common = "OPACITY 1 PHONG PLASTIC .5 PHONG_SIZE 3.0827 COLOR .5 .45 .35 TEXFUNC 0"
    print "TEXDEF Dull AMBIENT 0 DIFFUSE 1 SPECULAR 0 " common
    print "TEXDEF Shiny AMBIENT 0 DIFFUSE 1 SPECULAR .25 " common
  }
}
$1 == "sphere" {
  dull = $2 == "dull"
  r = $(2 + dull); x = $(3 + dull); y = $(4 + dull); z = $(5 + dull); surface = dull ? "Dull" : "Shiny"
  if (to == "povray") printf "sphere { <%s,%s,%s>, %s texture { %s } }\n", x, y, z, r, surface
  else printf "SPHERE CENTER %s %s %s RAD %s %s\n", y, x, z, r, surface
}
END { if (to != "povray") print "END_SCENE" }
