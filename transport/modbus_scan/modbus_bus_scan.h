#pragma once

#include "bus_scan.h"
#include "scan_answer.h"
#include "scan_line.h"

#include <memory>
#include <QSet>

namespace lds::modbus {

/// How long a scan listens. What the characters take on the line comes on top.
struct ScanTiming {
    int answerMs = 30;  ///< For an answer to begin: the sensor's own time and the adapter's.
    int silenceMs = 20; ///< After the last byte: USB adapters hand bytes on in pieces up to 16 ms apart.
    int listenMs = 20;  ///< With nothing asked, before each new setting.
};

/// Asks unit after unit, setting after setting. What is no answer is looked into before anything is said:
/// the unit is asked once more, then nobody, then an address nobody may have (248). Bytes that come only for
/// this unit are those of two units; bytes that come in any case are noise.
class ModbusBusScan final : public ports::BusScan {
    Q_OBJECT

public:
    explicit ModbusBusScan(std::unique_ptr<ScanLine> line, const ScanTiming& timing);
    ~ModbusBusScan() override;

protected:
    void doStart(const ports::ScanPlan& plan) override;
    void doCancel() override;

private:
    enum class Phase : quint8 {
        Idle,
        Opening,
        Listening, ///< Before the first unit of a setting.
        Asking,
        AskingAgain,
        ListeningForNoise,
        AskingNobody, ///< The reserved address.
    };

    void openNext();
    void opened();
    void heard(const QByteArray& bytes);
    void failed(const QString& detail);
    void exchange(Phase phase, const QByteArray& request, int windowMs);
    void ask(Phase phase);
    void judge(const ScanAnswer& answer);
    void takeLate(const ScanAnswer& answer);
    void report(ports::ScanFinding::Kind kind, quint8 unit);
    void reportNoise();
    void next();
    void finish(ports::ScanEnd end, const QString& detail = {});
    const ports::SerialSettings& serial() const { return m_plan.settings.at(m_setting); }

    const std::unique_ptr<ScanLine> m_line;
    const ScanTiming m_timing;
    ports::ScanPlan m_plan;
    Phase m_phase = Phase::Idle;
    qsizetype m_setting = 0;
    int m_unit = 0;
    int m_lateAnswers = 0; ///< While this unit is being asked.
    bool m_noisy = false;  ///< At this setting; said once.
    QSet<int> m_found;     ///< Units, at this setting.
    ports::ScanProgress m_progress;
};

} // namespace lds::modbus
