#include "solver/io/pvd_series.h"

#include "solver/io/csv.h"
#include "solver/io/vtk_xml.h"

namespace plumbline {

void write_pvd(std::ostream& out, const std::vector<SeriesMember>& members) {
    begin_vtk(out, "Collection");
    for (const SeriesMember& m : members)
        out << "<DataSet timestep=\"" << digits17(m.time) << "\" part=\"0\" file=\""
            << xml_escaped(m.file) << "\"/>\n";
    end_vtk(out, "Collection");
}

}  // namespace plumbline
