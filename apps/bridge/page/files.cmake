# The files of the page that are built into RTBridge. The first one is what `/` shows.
set(BRIDGE_PAGE_FILES
    index.html
    page.css
    icon.svg
    js/around.js
    js/bookmarks.js
    js/dom.js
    js/edits.js
    js/fields.js
    js/fragment.js
    js/gamepad.js
    js/held.js
    js/input.js
    js/key_table.js
    js/link.js
    js/main.js
    js/notices.js
    js/painter.js
    js/panel_lights.js
    js/panel_model.js
    js/panel_page.js
    js/panel_people.js
    js/panel_settings.js
    js/panel_sky.js
    js/panel_views.js
    js/panels.js
    js/picture.js
    js/picture_worker.js
    js/setting_labels.js
    js/statistics.js
    js/storage.js
    js/texts.js
    js/texts_cs.js
    js/texts_en.js
    js/touch.js
    js/wake_lock.js
    js/wire.js)

# Made from the translations of the window, without Qt.
set(BRIDGE_PAGE_MADE_FILES js/tables_cs.js)
set(BRIDGE_PAGE_MADE_FOLDER ${CMAKE_CURRENT_BINARY_DIR}/page_made)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(translations ${CMAKE_SOURCE_DIR}/apps/gui/translations/tables_cs.ts ${CMAKE_SOURCE_DIR}/apps/gui/translations/gui_cs.ts)
file(GLOB modules CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/js/*.js)
add_custom_command(
    OUTPUT ${BRIDGE_PAGE_MADE_FOLDER}/js/tables_cs.js
    COMMAND ${CMAKE_COMMAND} -E make_directory ${BRIDGE_PAGE_MADE_FOLDER}/js
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/tables_cs.py ${translations} ${modules}
            -o ${BRIDGE_PAGE_MADE_FOLDER}/js/tables_cs.js
    DEPENDS ${CMAKE_CURRENT_LIST_DIR}/tables_cs.py ${translations} ${modules}
    COMMENT "Czech texts of the page's tables")
