#!/usr/bin/env bash
# layers_file.sh WHITTLE: the file of --aov as OpenImageIO's own tool reads it: channels, names of objects, values.
set -euo pipefail
whittle=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cat >"$place/s.pov" <<'S'
#version 3.7; global_settings { assumed_gamma 1 }
camera { orthographic location <0,0,-10> look_at 0 right 4*x up 4*y }
#declare Ball = sphere { 0, 1.5 }
object { Ball pigment { rgb <1,.5,0> } finish { ambient 1 diffuse 0 } }
S
"$whittle" "$place/s.pov" +W65 +H65 +A --aov=all +FN16 -GA 2>/dev/null
said=$(oiiotool --info -v "$place/s.layers.exr")
for word in "CryptoObject02.A" "depth.Z" "time.ns" '"Ball"' "MurmurHash3_32" "65 x   65"; do
    grep -qF -- "$word" <<<"$said" || { echo "no $word in: $said"; exit 1; }
done
# The pixel in the middle: colour 1, .5, 0; the ball is 8.5 away.
middle=$(oiiotool "$place/s.layers.exr" --ch R,G,B,A,depth.Z,CryptoObject00.G --cut 1x1+32+32 --printstats | grep "Stats Avg")
echo "$middle"
grep -qE '1\.0+ 0\.50* 0\.0+ 1\.0+ 8\.50* 1\.0+' <<<"$middle"
# A picture that goes to standard output has no place for them; a word that is none is named; nothing is left behind.
! "$whittle" "$place/s.pov" +O- --aov=depth >/dev/null 2>"$place/err" && grep -q "beside the picture" "$place/err"
rm "$place/s.png"
! "$whittle" "$place/s.pov" --aov=depht 2>"$place/err" && grep -q "'depht' is no layer" "$place/err"
[[ ! -e $place/s.png ]]
