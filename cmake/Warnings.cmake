# The compiler options of every target of ours.
add_library(rt_compile_options INTERFACE)
target_compile_options(rt_compile_options INTERFACE
    -Wall -Wextra -Wconversion -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    # a*b+c is never fused: fused, the same picture would have other bits on other processors.
    -ffp-contract=off
    # GCC 12 sees an overlap in `"text" + std::string` that is not there (GCC bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<BOOL:${RT_WERROR}>:-Werror>)
if(NOT RT_EVERY_INSTRUCTION_SET)
    target_compile_definitions(rt_compile_options INTERFACE RT_FEW_INSTRUCTION_SETS)
endif()
if(RT_SANITIZE)
    target_compile_options(rt_compile_options INTERFACE
        -fsanitize=${RT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
        $<$<BOOL:$<TARGET_PROPERTY:RT_TEST_CODE>>:-fno-sanitize=undefined>)
    if(RT_SANITIZE_WITHOUT)
        target_compile_options(rt_compile_options INTERFACE -fno-sanitize=${RT_SANITIZE_WITHOUT})
    endif()
    target_link_options(rt_compile_options INTERFACE -fsanitize=${RT_SANITIZE})
endif()
if(OpenMP_CXX_FOUND)
    target_link_libraries(rt_compile_options INTERFACE OpenMP::OpenMP_CXX)
else()
    target_compile_options(rt_compile_options INTERFACE -Wno-unknown-pragmas)
endif()
