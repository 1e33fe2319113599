# Flags that hold for what is built here and never for those who use the library.

# Interface target: the warnings that everything in this tree is free of.
add_library(trama_warnings INTERFACE)
if(MSVC)
    target_compile_options(trama_warnings INTERFACE /W4)
else()
    target_compile_options(trama_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
endif()
if(TRAMA_WERROR)
    target_compile_options(trama_warnings INTERFACE $<IF:$<CXX_COMPILER_ID:MSVC>,/WX,-Werror>)
endif()

# Interface target: the library does without exceptions and type information.
include(CheckCXXCompilerFlag)
add_library(trama_lean INTERFACE)
foreach(flag IN ITEMS -fno-exceptions -fno-rtti)
    string(MAKE_C_IDENTIFIER "TRAMA_HAS${flag}" known)
    check_cxx_compiler_flag(${flag} ${known})
    if(${known})
        target_compile_options(trama_lean INTERFACE ${flag})
    endif()
endforeach()

# A build without a type is an optimised one. A parent project decides for itself.
function(trama_default_build_type type)
    get_property(multi GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
    if(PROJECT_IS_TOP_LEVEL AND NOT multi AND NOT CMAKE_BUILD_TYPE)
        set(CMAKE_BUILD_TYPE ${type} CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
    endif()
endfunction()

# Turns on the sanitizers named, for every target that follows; any report ends the program.
macro(trama_sanitize)
    if(NOT "${ARGN}" STREQUAL "")
        string(REPLACE ";" "," names "${ARGN}")
        add_compile_options(-fsanitize=${names} -fno-sanitize-recover=all -fno-omit-frame-pointer)
        add_link_options(-fsanitize=${names})
    endif()
endmacro()
