# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DLUPDATE=... -DSOURCE=... -DFILE=... -DCOPY=... -P check_current.cmake
# Fails where the translation lacks a text of the sources, or holds one that is unfinished.
configure_file(${FILE} ${COPY} COPYONLY)
execute_process(COMMAND ${LUPDATE} -silent -no-obsolete -locations none -I ${SOURCE} ${SOURCE}/ui
                        ${SOURCE}/app/kambara -ts ${COPY}
                RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "lupdate failed: ${result}")
endif()
file(READ ${COPY} text)
string(REGEX MATCHALL "<source>[^<]*</source>[^/]*type=\"unfinished\"" missing "${text}")
foreach(entry IN LISTS missing)
    message("not translated: ${entry}")
endforeach()
if(text MATCHES "unfinished")
    message(FATAL_ERROR "${FILE} is not complete. Update it (target update_translations), translate.")
endif()
