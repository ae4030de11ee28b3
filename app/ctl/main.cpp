// ldsctl: the core of LDS Studio without a window.

#include "catalog_command.h"
#include "command_line.h"
#include "console.h"
#include "info_command.h"
#include "interrupt.h"
#include "modbus_link_factory.h"
#include "monitor_command.h"
#include "no_frame_log.h"
#include "qt_scheduler.h"
#include "read_command.h"
#include "set_command.h"
#include "texts.h"

#include <cstdio>
#include <memory>
#include <QCoreApplication>
#include <QFile>

namespace {

using namespace lds;
using namespace lds::ctl;

std::unique_ptr<SessionCommand> makeCommand(const CommandLine& line, sensor::SensorSession& session,
                                            ports::Scheduler& scheduler, Console& console)
{
    switch (line.verb) {
    case Verb::Info:
        return std::make_unique<InfoCommand>(line, session, scheduler, console);
    case Verb::Read:
        return std::make_unique<ReadCommand>(line, session, scheduler, console);
    case Verb::Set:
        return std::make_unique<SetCommand>(line, session, scheduler, console);
    case Verb::Monitor:
        return std::make_unique<MonitorCommand>(line, session, scheduler, console);
    case Verb::Catalog:
        break;
    }
    return {};
}

sensor::SensorSession::Timing timingFor(const CommandLine& line)
{
    sensor::SensorSession::Timing timing;
    timing.pollIntervalMs = line.verb == Verb::Monitor ? line.intervalMs : 0; // no one looks at the polls
    return timing;
}

int runSession(const CommandLine& line, Console& console)
{
    ports::registerMetaTypes();
    ports::QtScheduler scheduler;
    NoFrameLog frames;
    modbus::ModbusLinkFactory links(frames);
    sensor::SensorSession session(*line.url, links, scheduler);
    session.setTiming(timingFor(line));
    const auto command = makeCommand(line, session, scheduler, console);
    std::unique_ptr<Interrupt> interrupt;
    if (auto* monitor = qobject_cast<MonitorCommand*>(command.get()))
        interrupt = std::make_unique<Interrupt>(scheduler, [monitor] { monitor->interrupt(); });

    // Queued: a command may end before the event loop begins.
    QObject::connect(
        command.get(), &SessionCommand::finished, QCoreApplication::instance(),
        [](ExitCode code) { QCoreApplication::exit(int(code)); }, Qt::QueuedConnection);
    command->start();
    return QCoreApplication::exec();
}

} // namespace

int main(int argc, char* argv[])
{
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("ldsctl"));
    QCoreApplication::setApplicationVersion(QStringLiteral(LDS_VERSION));
    QFile output;
    QFile errors;
    if (!output.open(stdout, QIODevice::WriteOnly) || !errors.open(stderr, QIODevice::WriteOnly))
        return int(ExitCode::Refused);
    Console console(output, errors);

    const auto parsed = parseCommandLine(QCoreApplication::arguments());
    if (!parsed) {
        console.message(parsed.error().message);
        console.message(Texts::tr("“ldsctl --help” explains the commands."));
        return int(ExitCode::Usage);
    }
    if (const auto* answer = std::get_if<Answer>(&*parsed)) {
        console.line(answer->text);
        return int(ExitCode::Done);
    }
    const auto& line = std::get<CommandLine>(*parsed);
    return line.verb == Verb::Catalog ? int(CatalogCommand(line, console).run()) : runSession(line, console);
}
