# Folders that an installation makes are for everybody, as installed files are, whatever the umask of its builder: where it
# makes them on the way to a file, install() leaves them to the umask, even with CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS.
# Folders that are there already keep their modes.

# Before the first install().
function(rt_note_missing_folders)
    install(CODE [[
        set(rt_missing_folders)
        # All that anything is installed into.
        foreach(folder bin libexec/rtsuite share/applications share/bash-completion/completions share/doc/rtsuite
                share/icons/hicolor/scalable/apps share/icons/hicolor/scalable/mimetypes share/man/man1
                share/mime/packages share/rtsuite/scenes)
            set(folder "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${folder}")
            while(NOT EXISTS "${folder}")
                list(APPEND rt_missing_folders "${folder}")
                cmake_path(GET folder PARENT_PATH folder)
            endwhile()
        endforeach()]] ALL_COMPONENTS)
endfunction()

# After the last one.
function(rt_open_made_folders)
    install(CODE [[
        foreach(folder IN LISTS rt_missing_folders)
            if(EXISTS "${folder}")
                file(CHMOD "${folder}" DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
                    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
            endif()
        endforeach()]] ALL_COMPONENTS)
endfunction()
