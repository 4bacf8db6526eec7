# Makes templates.h out of the files of this folder, so that the program needs no file beside it.
file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/page/*.mustache
     ${CMAKE_CURRENT_SOURCE_DIR}/page/*.css)
set(PLUMBLINE_TEMPLATES "")
foreach(file ${files})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(name ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND PLUMBLINE_TEMPLATES
           "inline constexpr const char* ${name} = R\"template(${text})template\";\n")
endforeach()
configure_file(page/templates.h.in ${PROJECT_BINARY_DIR}/generated/reports/page/templates.h @ONLY)
