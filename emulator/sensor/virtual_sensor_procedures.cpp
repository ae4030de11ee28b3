// Teaching (§4.9) and brightness tuning (§4.3.3) of a virtual sensor.
#include "virtual_sensor.h"

namespace lds::emulator {

using namespace catalog;

namespace {

WriteOutcome failed(const QString& reason) { return {0, Refusal::Failed, reason}; }
const WriteOutcome done{1, {}, {}};

} // namespace

/// "Cannot be started" (§4.3.3, §4.9); one procedure at a time.
bool VirtualSensor::canStartProcedure() const { return m_memory.value(ItemId::HoldMode) == 0; }

bool VirtualSensor::procedureByCommunication() const
{
    return (m_teaching.isExecuting() && m_teaching.operatedBy() == Operator::Communication) ||
           (m_tuning.isExecuting() && m_tuning.operatedBy() == Operator::Communication);
}

void VirtualSensor::interruptProcedures()
{
    m_teaching.interrupt();
    if (m_tuning.isExecuting())
        abandonTuning();
    m_tuning.interrupt();
}

WriteOutcome VirtualSensor::startTeaching(Operator by)
{
    if (!canStartProcedure())
        return failed(QStringLiteral("teaching cannot be started: hold mode is not None (§4.9)"));
    if (m_tuning.isExecuting())
        return failed(QStringLiteral("teaching cannot be started: brightness tuning is being executed"));
    m_teaching.start(m_memory.value(ItemId::TeachingMode), by);
    return done;
}

TeachingConditions VirtualSensor::teachingConditions() const
{
    const Limits& limits = hlG2(ItemId::HighSetValue).limitsFor(model());
    return {m_memory.value(ItemId::Tolerance), m_memory.value(ItemId::Hysteresis), limits.minimum,
            limits.maximum, limits.resolution};
}

WriteOutcome VirtualSensor::takeTeachingPoint(int point)
{
    catchUp();
    if (point != m_teaching.nextPoint() || point > m_teaching.points())
        return failed(QStringLiteral("point %1 is not the next one of teaching").arg(point));
    const bool holding = m_chain.holding();
    const auto window = m_teaching.take({m_chain.value(), m_chain.alarm(), isOutsideDisplay(), holding},
                                        teachingConditions());
    if (window)
        finishTeaching(*window);
    if (holding) // §4.9: "changes to indeterminate state after execution"
        m_chain.restart();
    return done;
}

void VirtualSensor::finishTeaching(const TaughtWindow& window)
{
    m_memory.setValue(ItemId::HighSetValue, window.high);
    m_memory.setValue(ItemId::LowSetValue, window.low);
    if (m_teaching.operatedBy() == Operator::Keys)
        saveItems({ItemId::HighSetValue, ItemId::LowSetValue});
    refresh();
}

WriteOutcome VirtualSensor::interruptTeaching()
{
    m_teaching.interrupt();
    return done;
}

WriteOutcome VirtualSensor::startTuning(Operator by)
{
    if (!canStartProcedure())
        return failed(QStringLiteral("brightness tuning cannot be started: hold mode is not None (§4.3.3)"));
    if (m_teaching.isExecuting())
        return failed(QStringLiteral("brightness tuning cannot be started: teaching is being executed"));
    if (!m_tuning.isExecuting())
        m_brightnessBefore = m_memory.value(ItemId::BrightnessTuning);
    m_tuning.start(by);
    m_memory.setValue(ItemId::BrightnessTuning, 1);
    refresh();
    return done;
}

WriteOutcome VirtualSensor::takeTuningPoint(int point)
{
    catchUp();
    if (point != m_tuning.nextPoint() || point < 1)
        return failed(QStringLiteral("point %1 is not the next one of brightness tuning").arg(point));
    const bool holding = m_chain.holding();
    if (holding || m_chain.alarm() || !m_chain.value())
        abandonTuning();
    else
        m_tuning.take(m_sampledNs);
    if (holding) // §4.3.3: "changes to indeterminate state after execution"
        m_chain.restart();
    return done;
}

void VirtualSensor::sampleTuning(qint64 timeNs)
{
    if (m_chain.alarmNow()) {
        abandonTuning();
        return;
    }
    if (const auto range = m_tuning.sample(m_receiver, timeNs))
        finishTuning(*range);
    else if (m_tuning.state() == TuningState::Failed)
        abandonTuning();
}

void VirtualSensor::finishTuning(const BrightnessRange& range)
{
    m_memory.setTunedBrightness(m_memory.bank(), range);
    if (m_tuning.operatedBy() == Operator::Keys)
        saveItems({ItemId::BrightnessTuning});
    applySettings();
}

/// It has failed: the adjustment method stays what it was before.
void VirtualSensor::abandonTuning()
{
    m_tuning.fail();
    m_memory.setValue(ItemId::BrightnessTuning, m_brightnessBefore);
    applySettings();
}

WriteOutcome VirtualSensor::interruptTuning()
{
    if (m_tuning.isExecuting())
        abandonTuning();
    m_tuning.interrupt();
    refresh();
    return done;
}

} // namespace lds::emulator
