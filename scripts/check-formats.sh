#!/bin/sh
# Renders one model of every format in the package assimp-testmodels and prints a table. Fails when fewer than 40
# extensions give a picture. Usage: check-formats.sh [folder of the programs] [folder of the models]
set -u
cd "$(dirname "$0")/.." || exit 1
programs=${1:-build/release/bin}
models=${2:-/usr/share/assimp/models}
wanted=40

if [ ! -d "$models" ]; then
    echo "skipped: there is no $models (package assimp-testmodels)"
    exit 0
fi
if [ ! -x "$programs/Renderer" ] || [ ! -x "$programs/rtimport" ]; then
    echo "$programs: Renderer or rtimport is missing; build them first (scripts/build.sh)" >&2
    exit 1
fi
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM

# Formats of Debian's Assimp 5.2, but for animations without a model, and .bsp and .scn, which mean our own files.
extensions="3d 3ds 3mf ac ac3d acc amf ase ask assbin b3d blend bvh cob csm dae dxf enff fbx glb gltf hmp ifc ifczip
iqm irr irrmesh lwo lws lxo md2 md3 md5mesh mdc mdl mesh mot ms3d ndo nff obj off ogex pk3 ply pmx prj q3o q3s raw
sib smd step stl stp ter uc vta x x3d x3db xgl xml zae zgl"

# From BSPBuilder's report.
triangles() {
    "$programs/BSPBuilder" "$1" "$scratch/model.bsp" -f -v 2>&1 </dev/null | sed -n 's/^triangles: *//p'
}

picture() {
    rm -f "$scratch/picture.png"
    timeout 120 "$programs/Renderer" "$1" -o "$scratch/picture.png" -w 160 -h 120 >"$scratch/log" 2>&1 &&
        [ -s "$scratch/picture.png" ]
}

printf '%-8s %-10s %-9s %s\n' format triangles result file
count=0
found=0
for extension in $extensions; do
    # The smallest first: quick, and what is broken on purpose stands in folders of its own.
    find "$models" -type f -iname "*.$extension" ! -path '*/invalid/*' -printf '%s %p\n' | sort -n |
        cut -d' ' -f2- >"$scratch/files"
    [ -s "$scratch/files" ] || continue
    found=$((found + 1))
    result=none
    while IFS= read -r file; do
        if picture "$file" </dev/null; then
            result=picture
            break
        fi
        reason=$(tail -n 1 "$scratch/log" | cut -c1-150)
    done <"$scratch/files"
    if [ "$result" = picture ]; then
        count=$((count + 1))
        printf '%-8s %-10s %-9s %s\n' "$extension" "$(triangles "$file")" picture "${file#"$models"/}"
    else
        printf '%-8s %-10s %-9s %s\n' "$extension" - none "$reason"
    fi
done
echo "$count of $found extensions with test models give a picture (wanted: $wanted)"
[ "$count" -ge "$wanted" ]
