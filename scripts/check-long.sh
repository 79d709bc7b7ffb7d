#!/bin/sh
# The checks that take too long for every run; their output belongs into the note that closes an issue.
#   scripts/check-long.sh [formulas] [leaks] [leaving] [trees] [waves] [oracle] [mutations] [scn] [kills] [formats] [ipc] [server]
#                         [reaction] [soak] [edits] [scenes] [preview] [window] [walks] [tutorial] [models] [strangers] [sanitizers] [mutants]
#                         [bridge] [web] [farm] [plans] [arm64]
# Without arguments: all. RT_ISA chooses the instruction set of the kernels.
set -eu
cd "$(dirname "$0")/.."
scripts/build.sh
[ $# -gt 0 ] ||
    set -- formulas leaks leaving trees waves oracle mutations scn kills formats ipc server reaction soak edits scenes preview window \
        walks tutorial models strangers sanitizers mutants bridge web farm plans arm64
release=build/release/bin
# Builds these targets with all checks of the sanitizers, of which test.sh leaves some out.
sanitized() {
    cmake --preset asan-ubsan -DRT_EVERY_INSTRUCTION_SET=ON -DRT_SANITIZE_WITHOUT= >/dev/null
    cmake --build --preset asan-ubsan --target "$@"
}
for check in "$@"; do
    echo "== $check"
    case $check in
    strangers)
        # First views of models that nobody prepared, as numbers and as a sheet to be looked at.
        $release/test_strangers
        scripts/strangers.sh build/strangers
        # So many random glTF files beside plain ones that show the same.
        RT_GLTF_CENSUS=${RT_GLTF_CENSUS:-2000} $release/test_gltf_census
        # All models of assimp-testmodels beside the list that is kept, and beside what Blender reads of them.
        if command -v blender >/dev/null && [ -d /usr/share/assimp/models ]; then
            RT_CENSUS_PLAIN=$PWD/build/census_plain
            blender --background --factory-startup --python tests/strangers/blender_plain.py -- \
                /usr/share/assimp/models "$RT_CENSUS_PLAIN" >build/census_plain.log 2>&1
            export RT_CENSUS_PLAIN
        fi
        RT_MODEL_CENSUS=1 $release/test_model_census
        ;;
    plans)
        # Drawings to scale, opened and measured by other programs.
        scripts/check-plans.py $release
        ;;
    models)
        # Up axis and unit of 45 real models; what is not there is made by the programs that are installed.
        [ -n "${RT_TEST_SCENES:-}" ] || echo "check-long: RT_TEST_SCENES is not set: without its models" >&2
        [ -n "${RT_KNOWN_MODELS:-}" ] || {
            RT_KNOWN_MODELS=build/known_models
            QT_QPA_PLATFORM=offscreen python3 scripts/known_models.py "$RT_KNOWN_MODELS"
        }
        RT_KNOWN_MODELS=$(realpath "$RT_KNOWN_MODELS") $release/test_known_models
        ;;
    bridge)
        # So many seconds of frames, so many deaths, a minute beside 100 bad clients, five minutes of silence behind nginx.
        RT_BRIDGE_SOAK=${RT_BRIDGE_SOAK:-1800} RT_BRIDGE_DEATHS=${RT_BRIDGE_DEATHS:-200} \
            RT_BRIDGE_FLOOD=${RT_BRIDGE_FLOOD:-60} RT_BRIDGE_IDLE=${RT_BRIDGE_IDLE:-300} $release/test_bridge_process
        # So many damaged messages and heads of requests.
        sanitized test_bridge_process
        RT_BRIDGE_FUZZ=${RT_BRIDGE_FUZZ:-1000000} UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 \
            build/asan-ubsan/bin/test_bridge_process --gtest_filter='Requests.OfAnyBytesHarmNobody'
        RT_MUTATIONS=${RT_MUTATIONS:-1000000} UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 \
            build/asan-ubsan/bin/test_bridge_process --gtest_filter='DamagedHeads.HarmNobody'
        $release/bench_bridge
        ;;
    web)
        # The bridge's page in a real Chromium (Debian package chromium), which walks for so many seconds; without it all
        # are skipped.
        RT_BRIDGE_SOAK=${RT_BRIDGE_SOAK:-1800} RT_DRAGS=${RT_DRAGS:-1000} $release/test_web
        $release/test_web_modules
        ;;
    formulas)
        # Each formula for one number and for vectors of them, on so many inputs.
        RT_FORMULA_INPUTS=${RT_FORMULA_INPUTS:-10000000} $release/test_simd --gtest_filter='Formulas.*'
        ;;
    leaks)
        # So many rays for each kernel, five times as many in all; RT_ISA chooses the instruction set.
        RT_LEAK_RAYS=${RT_LEAK_RAYS:-100000000} $release/test_leaks
        ;;
    leaving)
        # So many rays in all, from triangles of 1 : 1 to 1 : 100,000, by every kernel and instruction set.
        RT_LEAVING_RAYS=${RT_LEAVING_RAYS:-1000000000} $release/test_leaving
        ;;
    trees)
        # Pictures by the exact tree and by fast ones, from so many places in each scene.
        [ -n "${RT_TEST_SCENES:-}" ] || echo "check-long: RT_TEST_SCENES is not set: only our own scenes" >&2
        RT_TREE_CAMERAS=${RT_TREE_CAMERAS:-50} $release/test_trees
        ;;
    waves)
        RT_WAVE_ROUNDS=${RT_WAVE_ROUNDS:-200} $release/test_kernels --gtest_filter='AwkwardWaves.*-*EqualTriangles*'
        RT_EQUAL_TRIANGLES=${RT_EQUAL_TRIANGLES:-10000000} $release/test_kernels --gtest_filter='*EqualTriangles*'
        ;;
    oracle)
        [ -n "${RT_TEST_SCENES:-}" ] || echo "check-long: RT_TEST_SCENES is not set: nothing to check" >&2
        RT_ORACLE_RAYS=${RT_ORACLE_RAYS:-1000000} $release/test_embree
        # So many rays in each of twelve scenes that planes cut open, beside triangles that are cut by themselves.
        RT_SECTION_RAYS=${RT_SECTION_RAYS:-3000000} $release/test_render --gtest_filter='Sections.RaysMeetWhatIsLeft'
        ;;
    mutations)
        sanitized unit_tests
        # Files of scenes, models, scans, cameras, settings and lists, answers to state, messages.
        RT_MUTATIONS=${RT_MUTATIONS:-1000000} ctest --preset asan-ubsan --timeout 3600 -R 'Mutat|DamagedFilesAreSoundOrRefused' -j "$(nproc)" --verbose
        # So many of each of 21 kinds of image files.
        RT_MUTATIONS=${RT_IMAGE_MUTATIONS:-50000} ctest --preset asan-ubsan --timeout 3600 -R ChangedAnywhere -j "$(nproc)" --verbose
        ;;
    scn)
        # So many damaged scenes of both versions; what is still read is written and read again.
        sanitized test_text
        RT_MUTATIONS=${RT_MUTATIONS:-1000000} UBSAN_OPTIONS=print_stacktrace=1 \
            build/asan-ubsan/bin/test_text --gtest_filter=Mutation.ScenesAreReadOrRefused
        ;;
    kills)
        RT_KILLS=${RT_KILLS:-500} ctest --preset release --timeout 3600 -R Kill --verbose
        ;;
    ipc)
        RT_IPC_ROUNDS=${RT_IPC_ROUNDS:-25} $release/test_ipc_process
        RT_MUTATIONS=${RT_MUTATIONS:-1000000} $release/test_ipc
        $release/bench_ipc
        # Once more for what others on this machine take.
        $release/bench_ipc --guard || $release/bench_ipc --guard
        ;;
    server)
        # 50 kills, times the factor; the floods last as many seconds.
        RT_IPC_ROUNDS=${RT_IPC_ROUNDS:-20} RT_START_KILLS=${RT_START_KILLS:-500} \
            $release/test_server_faults --gtest_filter=-Soak.*
        ;;
    reaction)
        # RT_SERVERS: other RTServers, which take turns with this one, such as one of before a change.
        # shellcheck disable=SC2086
        $release/bench_reaction $release/RTServer ${RT_SERVERS:-}
        ;;
    soak)
        RT_SOAK_SECONDS=${RT_SOAK_SECONDS:-1200} $release/test_server_faults --gtest_filter=Soak.*
        ;;
    edits)
        # So many random edits while one walks, each seen within eight live frames.
        sanitized test_rtserver test_gathering
        RT_EDITS=${RT_EDITS:-10000} UBSAN_OPTIONS=print_stacktrace=1 \
            build/asan-ubsan/bin/test_rtserver --gtest_filter='RandomEdits.*'
        # Edits and switches of variants, all taken back to the first bits.
        RT_EDITS=${RT_EDITS_OF_VARIANTS:-1000} UBSAN_OPTIONS=print_stacktrace=1 \
            build/asan-ubsan/bin/test_rtserver --gtest_filter='VariantCommands.TakenBack*'
        # The same of indirect light, which ends as one that is learned of the last state alone.
        RT_EDITS=${RT_EDITS:-10000} UBSAN_OPTIONS=print_stacktrace=1 \
            build/asan-ubsan/bin/test_gathering --gtest_filter='Edits.*'
        # Edits in all buildings, by other random numbers.
        for seed in 1 2 3; do
            RT_BUILDINGS=$seed $release/test_gathering --gtest_filter='EditedRooms.*:*/EditsOfRooms.*'
        done
        # After so many states the scene that is exported shows the same bits.
        RT_EDIT_STATES=${RT_EDIT_STATES:-200} UBSAN_OPTIONS=print_stacktrace=1 \
            build/asan-ubsan/bin/test_rtserver --gtest_filter='SavedEdits.*'
        # So many of the window and of CUI at once, all taken back to the first bits.
        RT_EDITS=${RT_EDITS_AT_ONCE:-1000} QT_QPA_PLATFORM=offscreen \
            build/release/bin/test_gui --gtest_filter='EditsAtOnce.*'
        ;;
    scenes)
        # So many scenes and settings of random numbers, by paths and by Whitted's ray tracing.
        sanitized test_render
        RT_RANDOM_SCENES=${RT_RANDOM_SCENES:-1000} UBSAN_OPTIONS=print_stacktrace=1 \
            build/asan-ubsan/bin/test_render --gtest_filter='RandomScenes.*:OddNumbers.*'
        ;;
    sanitizers)
        sanitized unit_tests test_server_process test_server_faults test_bridge_process test_bridge_beside_server
        bin=build/asan-ubsan/bin
        UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=allocator_may_return_null=1 \
            ctest --preset asan-ubsan -j "$(nproc)" -L unit
        RT_MUTATIONS=${RT_SCRIBBLES:-100000} $bin/test_ipc --gtest_filter='Scribble.*:Queues.*'
        UBSAN_OPTIONS=print_stacktrace=1 $bin/test_server_process
        UBSAN_OPTIONS=print_stacktrace=1 $bin/test_server_faults
        UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 $bin/test_bridge_process
        UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 $bin/test_bridge_beside_server
        ;;
    preview)
        RT_PREVIEW_KILLS=${RT_PREVIEW_KILLS:-1000} $release/test_preview_process
        ;;
    window)
        RT_INTERRUPTIONS=${RT_INTERRUPTIONS:-1000} $release/test_gui --gtest_filter='*Interrupted*'
        # So many drags by every button, after which the model is there again.
        RT_DRAGS=${RT_DRAGS:-1000} $release/test_gui --gtest_filter='OrbitTest.HomeShows*'
        ;;
    walks)
        [ -n "${RT_TEST_SCENES:-}" ] || echo "check-long: RT_TEST_SCENES is not set: only our own nave" >&2
        export RT_WALKS="${RT_WALKS:-10000}"
        $release/test_motion --gtest_filter='RandomWalk.*'
        $release/test_walks
        $release/bench_motion data/nave/generated/nave.glb 1
        ;;
    tutorial)
        # In the sizes that it names.
        RT_TUTORIAL_FULL=1 $release/test_process --gtest_filter='Tutorial.*'
        ;;
    mutants)
        scripts/check-mutants.sh
        scripts/check_kernel_mutants.py
        scripts/check_bridge_mutants.py
        ;;
    farm)
        # A cluster of two nodes (root, slurm-wlm, munge, ffmpeg; skipped without), and each name alone in each of three places.
        ctest --preset release -R '^farm[.](slurm|parallel)$' --output-on-failure
        for engine in slurm parallel; do
            tests/farm/names_test.sh "$PWD/$release/Renderer" "$PWD" "$engine" apart || [ $? = 77 ]
        done
        ;;
    arm64)
        # Root, and the network for the first time; skipped without.
        scripts/check-arm64.sh
        ;;
    formats)
        scripts/check-formats.sh
        ;;
    *)
        echo "check-long: no check is called $check" >&2
        exit 2
        ;;
    esac
done
