#pragma once

#include "modbus_rtu_framing.h"
#include "scan_line.h"

#include <functional>
#include <QList>

namespace lds::modbus {

/// A line on which the test decides what is heard after each request. Time is only added up.
class ScriptedLine final : public ScanLine {
public:
    struct Asked {
        ports::SerialSettings serial;
        QByteArray request;
    };
    /// Shared with the test: the scan owns the line.
    struct Script {
        std::function<QByteArray(const Asked&)> answer = [](const Asked&) { return QByteArray(); };
        std::function<QString(const ports::SerialSettings&)> refuseOpening; ///< Empty text: it opens.
        std::function<bool(const Asked&)> breaks;                           ///< The port is gone.
        QList<Asked> asked;
        QList<ports::SerialSettings> opened;
        int elapsedMs = 0;
        bool isOpen = false;
    };

    explicit ScriptedLine(Script& script)
        : m_script(script)
    {}

    void open(const QString&, const ports::SerialSettings& serial) override
    {
        m_serial = serial;
        const QString refusal = m_script.refuseOpening ? m_script.refuseOpening(serial) : QString();
        later([this, refusal, serial] {
            if (!refusal.isEmpty()) {
                Q_EMIT failed(refusal);
                return;
            }
            m_script.opened.append(serial);
            m_script.isOpen = true;
            Q_EMIT opened();
        });
    }
    void exchange(const QByteArray& request, int windowMs, int silenceMs) override
    {
        const Asked asked{m_serial, request};
        later([this, asked, windowMs, silenceMs] {
            m_script.asked.append(asked);
            if (m_script.breaks && m_script.breaks(asked)) {
                m_script.isOpen = false;
                Q_EMIT failed(QStringLiteral("Input/output error"));
                return;
            }
            const QByteArray bytes = m_script.answer(asked);
            const RtuRate rate{asked.serial.baud, asked.serial.bitsPerCharacter()};
            m_script.elapsedMs += int(charactersNs(rate, asked.request.size() + bytes.size()) / 1'000'000) +
                                  (bytes.isEmpty() ? windowMs : silenceMs);
            Q_EMIT heard(bytes);
        });
    }
    void close() override
    {
        m_script.isOpen = false;
        ++m_closings;
    }

private:
    void later(std::function<void()> work)
    {
        QMetaObject::invokeMethod(
            this,
            [this, work = std::move(work), closings = m_closings] {
                if (closings == m_closings)
                    work();
            },
            Qt::QueuedConnection);
    }

    Script& m_script;
    ports::SerialSettings m_serial;
    int m_closings = 0;
};

} // namespace lds::modbus
