#include "catalog_command.h"

#include "catalog.h"
#include "command_line.h"
#include "console.h"
#include "item_json.h"
#include "texts.h"

namespace lds::ctl {

namespace {

QString numberText(int number) { return number == 0 ? QStringLiteral("-") : QString::number(number); }

QStringList row(const catalog::SettingItem& item)
{
    const QString access = accessWord(item.access);
    return {QString::fromLatin1(item.key),
            numberText(item.menu),
            roleWord(item.role),
            access.isEmpty() ? QStringLiteral("-") : access,
            numberText(item.size),
            numberText(item.modbus ? item.modbus->number : 0),
            numberText(item.slmp ? item.slmp->device : 0),
            numberText(item.eip ? item.eip->attribute : 0),
            QString::fromUtf8(item.name)};
}

} // namespace

CatalogCommand::CatalogCommand(const CommandLine& line, Console& console)
    : m_line(line)
    , m_console(console)
{}

ExitCode CatalogCommand::run() const
{
    const auto& catalog = catalog::Catalog::hlG2();
    if (m_line.json) {
        m_console.json(catalogJson(catalog));
        return ExitCode::Done;
    }
    QList<QStringList> rows{{Texts::tr("KEY"), Texts::tr("MENU"), Texts::tr("ROLE"), Texts::tr("ACCESS"),
                             Texts::tr("BYTES"), Texts::tr("MODBUS"), Texts::tr("SLMP"), Texts::tr("EIP"),
                             Texts::tr("NAME")}};
    for (const auto& item : catalog.items())
        rows += row(item);
    const QStringList lines = alignedLines(rows);
    for (const QString& line : lines)
        m_console.line(line);
    return ExitCode::Done;
}

} // namespace lds::ctl
