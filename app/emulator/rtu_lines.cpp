#include "rtu_lines.h"

#include <QDir>
#include <QFileInfo>

namespace lds::app {

tl::expected<QString, QString> RtuLines::attach(emulator::RtuUnit& unit, const QString& link)
{
    const QString path = QDir::cleanPath(QFileInfo(link).absoluteFilePath());
    auto& port = m_ports[path];
    if (!port) {
        auto opened = emulator::RtuPort::open(path, m_clock);
        if (!opened) {
            m_ports.erase(path);
            return tl::unexpected(opened.error());
        }
        port = std::move(*opened);
    }
    port->line().attach(unit);
    return port->link();
}

} // namespace lds::app
