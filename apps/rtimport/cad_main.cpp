/// rtimport_cad: rtimport for STEP, IGES and BREP, by Open CASCADE. It takes the process of rtimport over,
/// with its limits and its parent's watch.
#include "rtimport/importer_run.h"

#include "rtcore/io/import/cad/cad_import.h"

int main(int argc, char** argv) { return importer::runImporter(argc, argv, rtcore::importCad); }
