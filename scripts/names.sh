# Sourced by scripts that hand on names of files, which may hold anything: line ends at their end, too, which $( ) takes away.

# absolute VARIABLE: it gets the absolute path of what it names.
absolute() { eval "case \$$1 in /*) ;; *) $1=\$PWD/\$$1 ;; esac"; }
# quoted NAME: as a shell reads it back, once.
quoted() {
    word=$(printf '%s.' "$1" | sed "s/'/'\\\\''/g")
    printf "'%s'" "${word%.}"
}
