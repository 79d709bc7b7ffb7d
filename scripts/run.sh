#!/bin/sh
# From a fresh clone to a picture: builds everything, makes the sample scene's .bsp, renders it.
#   scripts/run.sh [scene.scn]
set -eu
cd "$(dirname "$0")/.."
scripts/build.sh
bin=build/release/bin
scene=${1:-data/nave/nave.scn}
name=$(basename "$scene" .scn)
mkdir -p output
model=$(sed -n 's/^ *model *= *"\(.*\)".*/\1/p' "$scene" | head -n 1)
$bin/BSPBuilder -v "$(dirname "$scene")/$model" "output/$name.bsp"
sed "s|^ *model *=.*|model = \"$PWD/output/$name.bsp\"|" "$scene" >"$(dirname "$scene")/generated/$name-bsp.scn"
$bin/Renderer "$(dirname "$scene")/generated/$name-bsp.scn" --output "output/$name.png" --force
echo
echo "The picture is $PWD/output/$name.png"
