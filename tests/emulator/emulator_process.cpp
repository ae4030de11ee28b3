#include "emulator_process.h"

#include <QJsonDocument>

#include <signal.h>

namespace lds::test {

namespace {
constexpr int patienceMs = 20'000;
}

EmulatorProcess::EmulatorProcess(const QStringList& arguments)
{
    m_process.start(program(), arguments);
    bool alive = m_process.waitForStarted(patienceMs);
    while (alive && !m_process.canReadLine())
        alive = m_process.waitForReadyRead(patienceMs);
    m_line = m_process.readLine();
}

EmulatorProcess::~EmulatorProcess()
{
    m_process.kill();
    m_process.waitForFinished();
}

QString EmulatorProcess::program()
{
    return qEnvironmentVariable("LDS_BIN") + QStringLiteral("/lds-emulator");
}

QJsonObject EmulatorProcess::ready() const { return QJsonDocument::fromJson(m_line).object(); }

quint16 EmulatorProcess::port(const QJsonObject& ready, QLatin1StringView key)
{
    return quint16(ready.value(key).toInt());
}

QByteArray EmulatorProcess::control(const QByteArray& line)
{
    m_process.write(line + '\n');
    while (!m_process.canReadLine()) {
        if (!m_process.waitForReadyRead(patienceMs))
            return {};
    }
    return m_process.readLine();
}

int EmulatorProcess::endWith(int signal)
{
    ::kill(pid_t(m_process.processId()), signal);
    if (!m_process.waitForFinished(patienceMs) || m_process.exitStatus() != QProcess::NormalExit)
        return -1;
    return m_process.exitCode();
}

} // namespace lds::test
