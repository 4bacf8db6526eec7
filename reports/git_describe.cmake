# cmake -DOUTPUT=... -DSOURCE=... -P git_describe.cmake: writes which version is being built, and leaves
# the file alone when that has not changed, so that nothing is compiled again.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --tags
                OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
                RESULT_VARIABLE failed)
if(failed OR described STREQUAL "")
    set(described "unknown")
endif()
set(text "#pragma once\n\n#define PLUMBLINE_GIT_DESCRIBE \"${described}\"\n")
set(before "")
if(EXISTS ${OUTPUT})
    file(READ ${OUTPUT} before)
endif()
if(NOT text STREQUAL before)
    file(WRITE ${OUTPUT} "${text}")
endif()
