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
model=$(dirname "$scene")/$(sed -n 's/^ *model *= *"\(.*\)".*/\1/p' "$scene" | head -n 1)
$bin/BSPBuilder -v "$model" "output/$name.bsp"
$bin/Renderer "$scene" --model "output/$name.bsp" --output "output/$name.png" --force
echo
echo "The picture is $PWD/output/$name.png"
