# A flake of balls (sphereflake --paper, or its kin) in Tachyon's own form, on standard output.
$1 == "background" { background = $2 " " $3 " " $4 }
$1 == "eyep" { for (i = 1; i <= 3; ++i) eye[i] = $(i + 1) }
$1 == "lookp" { for (i = 1; i <= 3; ++i) ahead[i] = $(i + 1) - eye[i] }
$1 == "fov" { half = $2 * atan2(0, -1) / 360; zoom = 1 / (sin(half) / cos(half)) }
$1 == "light" { lights = lights "LIGHT CENTER " $4 " " $5 " " $6 " RAD 0.001 COLOR 1 1 1\n" }
$1 == "surface" {
  mirror = /reflect/ ? 0.5 : 0
  surfaces = surfaces "TEXDEF " $2 " AMBIENT 0 DIFFUSE 0.5 SPECULAR " mirror " OPACITY 1 PHONG PLASTIC 0.5 PHONG_SIZE 3 " \
    "COLOR 1 0.9 0.7 TEXFUNC 0\n"
}
$1 == "applysurf" { surface = $2 }
$1 == "sphere" {
  if (!begun++) {
    print "BEGIN_SCENE\nRESOLUTION 1024 1024\nCAMERA PROJECTION PERSPECTIVE ZOOM", zoom, "ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 6"
    print "CENTER", eye[1], eye[2], eye[3], "VIEWDIR", ahead[1], ahead[2], ahead[3], "UPDIR 0 0 1 END_CAMERA"
    printf "BACKGROUND %s\n%s%s", background, lights, surfaces
  }
  named = NF == 6
  print "SPHERE CENTER", $(NF - 2), $(NF - 1), $NF, "RAD", $(NF - 3), named ? $2 : surface
}
END { print "END_SCENE" }
