# A flake of balls (sphereflake --paper) in POV-Ray's own form, on standard output: the same view, light, colours and
# reflections. POV-Ray's y axis and handedness are set right by the view (z up, x to the left: right -x).
function vector(first) { return "<" $first "," $(first + 1) "," $(first + 2) ">" }
$1 == "background" { print "background { rgb", vector(2), "}" }
$1 == "eyep" { eye = vector(2) }
$1 == "lookp" { look = vector(2) }
$1 == "fov" { print "camera { location", eye, "sky z up y right -x angle", $2, "look_at", look, "}" }
$1 == "light" { print "light_source {", vector(4), "rgb", $2, "}" }
$1 == "surface" {
  mirror = /reflect/ ? "reflection 0.5" : ""
  print "#declare", $2, "= texture { pigment { rgb <1,.9,.7> } finish { ambient 0 diffuse .5 phong .5 phong_size 3", mirror, "} }"
}
$1 == "applysurf" { surface = $2 }
$1 == "sphere" { print "sphere {", vector(NF - 2) ",", $(NF - 3), "texture {", (NF == 6 ? $2 : surface), "} }" }
BEGIN { print "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 6 }" }
