#include "message_filter.h"

#include "catalog.h"
#include "message_text.h"
#include "sentences.h"

#include <algorithm>
#include <QStringList>

namespace lds::ui {

namespace {

struct Registers {
    int first;
    int last;
};

/// Where the catalog has what a poll reads: from the state to the intensity.
Registers polledRegisters()
{
    static const Registers polled = [] {
        Registers result{999'999, 0};
        using catalog::ItemId;
        for (const ItemId id :
             {ItemId::SensorState, ItemId::SelfMonitoringNotification, ItemId::SelfMonitoringCaution,
              ItemId::SelfMonitoringError, ItemId::ErrorCode, ItemId::MeasuredValue, ItemId::PeakIntensity}) {
            const catalog::SettingItem& item = catalog::hlG2(id);
            result.first = std::min(result.first, item.modbus->number);
            result.last = std::max(result.last, item.modbus->number + item.registerCount() - 1);
        }
        return result;
    }();
    return polled;
}

} // namespace

bool MessageFilter::accepts(const ports::Frame& frame) const
{
    if (hidePolls && isPoll(frame))
        return false;
    if (failuresOnly && !isFailure(frame))
        return false;
    if (thisSensorOnly && frame.peer != peer)
        return false;
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    if (words.isEmpty())
        return true;
    const QString hex = hexText(frame.bytes);
    if (hex.contains(text.simplified(), Qt::CaseInsensitive)) // "06 02 50" as it stands
        return true;
    const QString sentence = frameSentence(frame);
    return std::all_of(words.begin(), words.end(), [&](const QString& word) {
        return sentence.contains(word, Qt::CaseInsensitive) || hex.contains(word, Qt::CaseInsensitive) ||
               frame.peer.contains(word, Qt::CaseInsensitive);
    });
}

bool isPoll(const ports::Frame& frame)
{
    if (frame.meaning != ports::FrameMeaning::Read && frame.meaning != ports::FrameMeaning::Answer)
        return false;
    const Registers polled = polledRegisters();
    bool firstIsNumber = false;
    bool lastIsNumber = false;
    const int first = frame.arguments.value(0).toInt(&firstIsNumber);
    const int last = frame.arguments.value(1, frame.arguments.value(0)).toInt(&lastIsNumber);
    return firstIsNumber && lastIsNumber && first >= polled.first && last <= polled.last;
}

bool isFailure(const ports::Frame& frame)
{
    switch (frame.meaning) {
    case ports::FrameMeaning::Refused:
    case ports::FrameMeaning::NoAnswer:
    case ports::FrameMeaning::Malformed:
        return true;
    case ports::FrameMeaning::Disconnected:
        return !frame.arguments.value(0).isEmpty();
    default:
        return false;
    }
}

} // namespace lds::ui
