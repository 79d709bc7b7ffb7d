# The files of the page that are built into RTBridge: those of this folder, and those that are made of it. The first one is
# what `/` shows.
set(BRIDGE_PAGE_FILES index.html page.css icon.svg js/texts_cs.js js/measuring.js js/plan.js plan.css)
set(BRIDGE_PAGE_MADE_FILES js/main.js js/stream_worker.js js/sentences_cs.js js/tables_cs.js)
set(BRIDGE_PAGE_MADE_FOLDER ${CMAKE_CURRENT_BINARY_DIR}/page_made)

find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(page ${CMAKE_CURRENT_LIST_DIR})
set(made ${BRIDGE_PAGE_MADE_FOLDER}/js)
file(MAKE_DIRECTORY ${made})
file(GLOB modules CONFIGURE_DEPENDS ${page}/js/*.js)

# Texts that the window has, too, without Qt.
set(translations ${CMAKE_SOURCE_DIR}/apps/gui/translations)
set(translations ${translations}/tables_cs.ts ${translations}/sentences_cs.ts ${translations}/gui_cs.ts)
add_custom_command(
    OUTPUT ${made}/tables_cs.js ${made}/sentences_cs.js
    COMMAND ${Python3_EXECUTABLE} ${page}/tables_cs.py ${translations} ${modules} -o ${made}
    DEPENDS ${page}/tables_cs.py ${translations} ${modules}
    COMMENT "Czech texts of the page" VERBATIM)

# One request each for the page and for its worker.
foreach(entry main.js stream_worker.js)
    add_custom_command(
        OUTPUT ${made}/${entry}
        COMMAND ${Python3_EXECUTABLE} ${page}/bundle.py ${entry} ${page}/js -o ${made}/${entry}
        DEPENDS ${page}/bundle.py ${modules}
        COMMENT "Joining the modules of ${entry}" VERBATIM)
endforeach()
