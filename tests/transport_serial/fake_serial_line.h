#pragma once

#include "manual_scheduler.h"
#include "serial_line.h"

#include <functional>
#include <memory>
#include <QList>
#include <QSet>

namespace lds::tests {

/// Other eyes on one clock: a bus owns its scheduler, and a test moves it.
class SharedClock final : public ports::Scheduler {
public:
    explicit SharedClock(std::shared_ptr<ports::ManualScheduler> clock)
        : m_clock(std::move(clock))
    {}
    qint64 nowNs() const override { return m_clock->nowNs(); }
    qint64 wallMs() const override { return m_clock->wallMs(); }
    TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override
    {
        return m_clock->after(delayMs, owner, std::move(callback));
    }
    void cancel(TimerId timer) override { m_clock->cancel(timer); }

private:
    std::shared_ptr<ports::ManualScheduler> m_clock;
};

/// A line that takes exchangeMs for an exchange, on a clock that a test moves.
class FakeSerialLine final : public modbus::SerialLine {
    Q_OBJECT

public:
    struct Asked {
        quint8 unit = 0;
        int function = 0;
        int timeoutMs = 0;
        qint64 atNs = 0;
    };

    explicit FakeSerialLine(std::shared_ptr<ports::ManualScheduler> clock)
        : m_clock(std::move(clock))
    {}

    int exchangeMs = 10;
    QSet<int> silentUnits;
    QList<Asked> asked;
    QList<QByteArray> written;
    QList<ports::SerialSettings> adopted;
    std::function<void(const QByteArray&)> onWrite; ///< For bytes written as they are.
    bool isOpen = false;

    tl::expected<void, modbus::PortFailure> open(const QString&, const ports::SerialSettings&) override
    {
        isOpen = true;
        return {};
    }
    void close() override { isOpen = false; }
    tl::expected<void, QString> adopt(const ports::SerialSettings& settings) override
    {
        adopted.append(settings);
        return {};
    }
    void ask(quint8 unit, const QByteArray& pdu, int timeoutMs) override;
    void write(const QByteArray& bytes) override
    {
        written.append(bytes);
        if (onWrite)
            onWrite(bytes);
    }
    void hear(const QByteArray& bytes) { Q_EMIT heard(bytes); }
    QList<int> dataUnits() const; ///< Whom data was asked of, in order.

private:
    std::shared_ptr<ports::ManualScheduler> m_clock;
    bool m_busy = false;
};

} // namespace lds::tests
